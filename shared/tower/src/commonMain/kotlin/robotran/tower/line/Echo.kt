package robotran.tower.line

/**
 * The number of bytes of [heard] that are the echo of [sent].
 *
 * A serial tower hears itself. Single bytes of its echo may be lost, wrong, or too many, as any others. So the echo is
 * followed byte by byte, and after a difference by its next two bytes. It ends where it cannot be followed any more: what
 * comes then is the answer, or a part of the echo that is too damaged to be told from one.
 */
internal fun echoSize(heard: ByteArray, sent: ByteArray): Int {
    var at = 0
    var expected = 0
    while (at < heard.size && expected < sent.size) {
        if (heard[at] != sent[expected]) {
            val gap = GAPS.firstOrNull { agree(heard, at + it.extra, sent, expected + it.missing) } ?: return at
            at += gap.extra
            expected += gap.missing
        }
        at++
        expected++
    }
    return at
}

/** Bytes to leave out of what was heard and of what was sent, so that the next ones agree. */
private data class Gap(val extra: Int, val missing: Int)

private val GAPS = listOf(Gap(0, 1), Gap(1, 0), Gap(1, 1), Gap(0, 2), Gap(1, 2), Gap(2, 2))

private fun agree(heard: ByteArray, at: Int, sent: ByteArray, expected: Int): Boolean {
    if (at >= heard.size || expected >= sent.size || heard[at] != sent[expected]) return false
    return at + 1 >= heard.size || expected + 1 >= sent.size || heard[at + 1] == sent[expected + 1]
}
