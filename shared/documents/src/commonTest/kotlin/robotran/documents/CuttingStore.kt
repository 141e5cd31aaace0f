package robotran.documents

/**
 * A store on a disk with [room] for this many more characters. A write that does not fit replaces the old text by as
 * much as fits, like a bad disk; then either the app is killed or the disk reports that it is full.
 */
internal class CuttingStore(private val disk: MemoryKeyValueStore, private var room: Int, private val kills: Boolean) :
    KeyValueStore by disk {
    override suspend fun write(name: String, text: String): StoreResult {
        if (text.length <= room) {
            room -= text.length
            return disk.write(name, text)
        }
        disk.write(name, text.take(room))
        room = 0
        if (kills) throw Killed()
        return StoreResult.Full
    }
}

/** The app was killed. */
internal class Killed : RuntimeException("killed")
