package robotran.lejoslinker

/** The bytes of an image, and what they hold. */
class LejosImage(val bytes: ByteArray)
