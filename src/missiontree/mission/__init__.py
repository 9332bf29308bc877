"""The frozen values that every floor speaks. Import the file that defines a name; this package re-exports nothing."""
