package robotran.tower.rcx

import robotran.legofirmware.device.DatalogEntry
import robotran.tower.LegoLimits
import robotran.tower.LineSpeed
import robotran.tower.RcxOpcode
import robotran.tower.TowerError
import robotran.tower.TowerResult
import robotran.tower.TransferProgress
import robotran.tower.Tries
import robotran.tower.line.Reply
import robotran.tower.line.Requests
import robotran.tower.line.twoBytes

/** Reads the datalog of LEGO's firmware. The brick keeps it. */
internal suspend fun readDatalog(
    requests: Requests,
    report: (TransferProgress) -> Unit,
): TowerResult<List<DatalogEntry>> {
    when (val versions = legoVersions(requests)) {
        is TowerResult.Failure -> return versions
        is TowerResult.Success -> Unit
    }
    return DatalogReader(requests, report).read()
}

private class DatalogReader(private val requests: Requests, private val report: (TransferProgress) -> Unit) {
    private val entries = ArrayList<DatalogEntry>()
    private var size = SIZES.first()
    private var repeats = 0

    suspend fun read(): TowerResult<List<DatalogEntry>> {
        // The first entry counts all, itself included.
        val count = when (val first = readSome(0, 1)) {
            is TowerResult.Failure -> return withoutFirst(first)
            is TowerResult.Success -> first.value.single().let { if (it.type == COUNT) it.value and 0xFFFF else 0 }
        }
        if (count !in 1..LegoLimits.DATALOG_ENTRIES) return TowerResult.Success(emptyList())
        while (entries.size < count - 1) {
            tell(count - 1)
            when (val some = readSome(entries.size + 1, minOf(size, count - 1 - entries.size))) {
                is TowerResult.Success -> entries += some.value
                is TowerResult.Failure -> if (!becomesSmaller(some.error)) return some
            }
        }
        tell(count - 1)
        return TowerResult.Success(entries)
    }

    /** Nobody knows whether a brick without datalog answers. One that is there otherwise has none. */
    private suspend fun withoutFirst(failed: TowerResult.Failure): TowerResult<List<DatalogEntry>> =
        if (failed.error == TowerError.BrickSilent && requests.reach() == null) {
            TowerResult.Success(emptyList())
        } else {
            failed
        }

    /** True if another try with fewer entries at once may succeed after [error]. */
    private fun becomesSmaller(error: TowerError): Boolean {
        val isLost = error == TowerError.BadConnection || error == TowerError.BrickSilent
        if (!isLost || size == SIZES.last()) return false
        size = SIZES.first { it < size }
        return true
    }

    private suspend fun readSome(first: Int, count: Int): TowerResult<List<DatalogEntry>> {
        val message = byteArrayOf(RcxOpcode.READ_DATALOG.toByte()) + twoBytes(first) + twoBytes(count)
        val tries = if (count <= SIZES.last()) Tries.SMALLEST_DATALOG else Tries.DATALOG
        val reply = requests.request(message, count * ENTRY_BYTES, tries)
        repeats += requests.attempts - 1
        return when (reply) {
            is Reply.Failure -> TowerResult.Failure(reply.error)
            is Reply.Success -> TowerResult.Success(reply.payload.toList().chunked(ENTRY_BYTES).map(::entryOf))
        }
    }

    private fun entryOf(bytes: List<Byte>) = DatalogEntry(
        bytes[0].toInt() and 0xFF,
        (bytes[1].toInt() and 0xFF) or (bytes[2].toInt() shl Byte.SIZE_BITS),
    )

    private fun tell(all: Int) {
        val left = all - entries.size
        val bytesLeft = 2 * ENTRY_BYTES * left + (left + size - 1) / size * MESSAGE_BYTES
        report(TransferProgress(entries.size, all, repeats, (LineSpeed.milliseconds(bytesLeft) + 999) / 1000))
    }

    private companion object {
        /** Entries in one answer, from clear to disturbed. */
        val SIZES = listOf(50, 20, 8, 2)
        const val ENTRY_BYTES = 3

        /** The type of the entry that counts them all. */
        const val COUNT = 0xFF

        /** A request and what is around the entries of its answer, on the line. */
        const val MESSAGE_BYTES = 22
    }
}
