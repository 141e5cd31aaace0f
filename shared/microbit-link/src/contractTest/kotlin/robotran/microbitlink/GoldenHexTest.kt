package robotran.microbitlink

import robotran.microbitlink.files.MAIN_FILE
import robotran.microbitlink.image.MicroPythonFile
import robotran.microbitlink.image.sha256
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** The files that the libraries of the foundation make of the same images and programs. */
class GoldenHexTest {
    private class Golden(line: String) {
        private val words = line.split(' ')
        val name = words[0]
        val image = words[1]
        val length = words[2].toInt()
        val sum = words[3]
        val files = vectors.filterKeys { it.startsWith("$name.") && it.endsWith(".py") }
            .map { (file, text) -> file.removePrefix("$name.") to text.encodeToByteArray() }
            .sortedByDescending { it.first == MAIN_FILE }.toMap()
    }

    private val golden = vector("sums.txt").lines().filter { it.isNotBlank() }.map { Golden(it) }
        .filter { it.image.startsWith("madeup") }

    private fun imageOf(golden: Golden): MicroPythonFile = when (golden.image) {
        "madeup-v1" -> madeUp(MicrobitBoard.V1)
        "madeup-v2" -> madeUp(MicrobitBoard.V2)
        else -> madeUpForBoth
    }

    @Test
    fun `a program is put into a file as the foundation's libraries do byte for byte`() {
        assertEquals(36, golden.size)
        for (each in golden) {
            val text = imageOf(each).textWith(each.files).value()
            assertEquals(each.length, text.length, "${each.name} ${each.image}")
            vectors["${each.name}.${each.image}.hex"]?.let { assertEquals(it, text, "${each.name} ${each.image}") }
            assertEquals(each.sum, sha256(text.encodeToByteArray()), "${each.name} ${each.image}")
        }
    }

    @Test
    fun `the files in every golden file are read back`() {
        for (each in golden) {
            val text = vectors["${each.name}.${each.image}.hex"] ?: continue
            val file = MicroPythonFile.read(text).value()
            assertEquals(if (file.isUniversal) 2 else 1, file.images.size)
            for (image in file.images.values) {
                assertEquals(each.files.texts(), image.files().value().texts(), "${each.name} ${each.image}")
            }
        }
    }

    @Test
    fun `files in a file are replaced`() {
        val before = MicroPythonFile.read(vector("two-files.madeup-universal.hex")).value()
        val after = before.textWith(mapOf(MAIN_FILE to vector("utf8.main.py").encodeToByteArray())).value()
        val fresh = madeUpForBoth.textWith(mapOf(MAIN_FILE to vector("utf8.main.py").encodeToByteArray())).value()
        assertEquals(fresh, after)
    }

    @Test
    fun `checksums are those of the standard`() {
        assertEquals(
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad",
            sha256("abc".encodeToByteArray()),
        )
        assertEquals(
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855",
            sha256(ByteArray(0)),
        )
        assertTrue((0..130).map { sha256(ByteArray(it)) }.toSet().size == 131)
    }
}
