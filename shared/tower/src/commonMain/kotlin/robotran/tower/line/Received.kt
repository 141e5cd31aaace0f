package robotran.tower.line

/** The result of reading for a while. */
internal sealed interface Received {
    class Bytes(val bytes: ByteArray) : Received

    data object Nothing : Received

    data object Gone : Received
}

/** Whether a serial tower hears itself. */
internal enum class Waking { AWAKE, SILENT, DISTURBED, GONE }
