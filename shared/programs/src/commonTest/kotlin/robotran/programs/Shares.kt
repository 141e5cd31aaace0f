package robotran.programs

/** The first element and each [share]-th after it. */
internal fun <T> List<T>.every(share: Int): List<T> = filterIndexed { index, _ -> index % share == 0 }
