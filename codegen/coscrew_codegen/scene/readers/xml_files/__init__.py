"""Files of XML: elements with their lines, and the shapes of links in them."""
