package robotran.legofirmware.device

import kotlin.test.Test
import kotlin.test.assertEquals

class DatalogCsvTest {
    @Test
    fun `each entry is a line that says where its value is from`() {
        val entries = listOf(0x00 to -5, 0x1F to 32767, 0x20 to 12, 0x42 to 57, 0x80 to 817, 0x43 to 1)
        val lines = listOf(
            "entry,source,number,value",
            "1,variable,0,-5",
            "2,variable,31,32767",
            "3,timer,1,12",
            "4,sensor,3,57",
            "5,watch,,817",
            "6,other,67,1",
        )
        assertEquals(lines.joinToString("\n", postfix = "\n"), csvOf(entries.map { DatalogEntry(it.first, it.second) }))
    }

    @Test
    fun `an empty datalog has only the line of names`() =
        assertEquals("entry,source,number,value\n", csvOf(emptyList()))
}
