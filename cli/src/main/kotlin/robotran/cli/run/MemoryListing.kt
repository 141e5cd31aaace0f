package robotran.cli.run

import robotran.rcxrom.memory.MemoryRegion
import robotran.rcxrom.memory.MemorySnapshot

/** A hex dump by region: each region has its name and rows of 16 bytes. Rows of zeros are replaced by `*`. */
internal fun memoryListing(memory: MemorySnapshot): String = buildString {
    for (region in MemoryRegion.entries) {
        val (first, last) = with(region.addresses) { hexadecimal(first) to hexadecimal(last) }
        appendLine("$first-$last ${region.name.lowercase().replace('_', ' ')}")
        var leftOut = false
        for (row in memory.rows(region.addresses)) {
            val empty = row.bytes.all { it == 0 }
            if (!empty) {
                appendLine("  ${row.text}")
            } else if (!leftOut) {
                appendLine("  *")
            }
            leftOut = empty
        }
    }
}

private fun hexadecimal(address: Int): String = address.toString(radix = 16).padStart(4, '0')
