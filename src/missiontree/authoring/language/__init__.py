"""What the offline author knows of English: verbs, nouns, small words, hazards."""
