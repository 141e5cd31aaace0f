package robotran.robolang.run

/** The largest whole number that is not above [value]; the nearest there is beyond 32 bits. */
internal fun floorToWhole(value: Float): Int {
    val truncated = value.toInt()
    return if (truncated > value) truncated - 1 else truncated
}

/** The smallest whole number that is not below [value]; the nearest there is beyond 32 bits. */
internal fun ceilToWhole(value: Float): Int {
    val truncated = value.toInt()
    return if (truncated < value && truncated < Int.MAX_VALUE) truncated + 1 else truncated
}

/** The whole number nearest to [value], the larger one if there are two; the nearest there is beyond 32 bits. */
internal fun roundToWhole(value: Float): Int {
    val below = floorToWhole(value)
    return if (value - below >= 0.5f && below < Int.MAX_VALUE) below + 1 else below
}
