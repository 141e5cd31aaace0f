package robotran.robolang.run

/** Rounds [value] down; saturates at 32 bits. */
internal fun floorToWhole(value: Float): Int {
    val truncated = value.toInt()
    return if (truncated > value) truncated - 1 else truncated
}

/** Rounds [value] up; saturates at 32 bits. */
internal fun ceilToWhole(value: Float): Int {
    val truncated = value.toInt()
    return if (truncated < value && truncated < Int.MAX_VALUE) truncated + 1 else truncated
}

/** Rounds [value] to the nearest whole number, halves up; saturates at 32 bits. */
internal fun roundToWhole(value: Float): Int {
    val below = floorToWhole(value)
    return if (value - below >= 0.5f && below < Int.MAX_VALUE) below + 1 else below
}
