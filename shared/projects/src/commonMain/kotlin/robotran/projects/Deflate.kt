package robotran.projects

/**
 * [bytes] compressed by deflate (RFC 1951), with nothing around it. How well is up to the platform; each reads what the
 * others have written.
 */
internal expect suspend fun deflate(bytes: ByteArray): ByteArray

/**
 * What [deflate] was given to get [compressed]; null if it is broken, cut off, goes on after its end or would become
 * longer than [max] bytes.
 */
internal expect suspend fun inflate(compressed: ByteArray, max: Int): ByteArray?
