package robotran.documents

/**
 * A store on a disk with [room] for so many more characters. The write that does not fit leaves as much as fits in
 * place of what was there, as a bad disk may do; then either the app is killed or the disk says that it is full.
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

/** The app is gone. */
internal class Killed : RuntimeException("killed")
