package robotran.tinyvm.config

/**
 * What a program is on a brick: an image in its memory, with classes and signatures numbered through. Without it, the
 * virtual machine estimates the size and has numbers in an order of its own.
 *
 * @property imageBytes size of the image.
 * @property classNumbers by internal name; a brick shows that of an exception that nobody catches.
 * @property signatureNumbers by name and descriptor; a brick shows that of the method with such an exception.
 */
class BrickLayout(val imageBytes: Int, val classNumbers: Map<String, Int>, val signatureNumbers: Map<String, Int>)
