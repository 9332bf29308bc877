"""What may be changed, how a change is applied to a copy of the inputs, and how it reads as an order. One file for each idea."""
