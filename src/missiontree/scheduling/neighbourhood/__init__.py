"""Large neighbourhoods: some roles of a schedule are taken out and put in elsewhere, over and over."""
