package robotran.projects

/**
 * Compresses [bytes] by raw deflate (RFC 1951). The compression ratio depends on the platform; each reads the output of
 * the others.
 */
expect suspend fun deflate(bytes: ByteArray): ByteArray

/**
 * Restores what was compressed by raw deflate (RFC 1951); null if [compressed] is damaged, truncated, has extra bytes
 * at the end, or would expand to more than [max] bytes.
 */
expect suspend fun inflate(compressed: ByteArray, max: Int): ByteArray?
