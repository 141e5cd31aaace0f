package robotran.lejoslinker

import robotran.lejoslinker.config.ByteOrder
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

class VectorsTest {
    @Test
    fun `images for a brick are those of the linker of leJOS byte for byte`() {
        assertEquals(IMAGES, Vectors.images.size)
        Vectors.images.forEach { (name, expected) -> compare(name, ByteOrder.BIG_ENDIAN, expected) }
    }

    @Test
    fun `images for the emulator are those of the linker of leJOS byte for byte`() {
        assertEquals(IMAGES, Vectors.imagesForEmulator.size)
        Vectors.imagesForEmulator.forEach { (name, expected) -> compare(name, ByteOrder.LITTLE_ENDIAN, expected) }
    }

    private fun compare(name: String, order: ByteOrder, expected: ByteArray) {
        val result = assertIs<ImageResult.Success>(linkVector(name, order), name)
        val bytes = result.image.bytes
        val first = expected.indices.firstOrNull { it >= bytes.size || bytes[it] != expected[it] }
        assertEquals(null, first, "$name $order differs at that byte")
        assertEquals(expected.size, bytes.size, "$name $order")
    }

    private companion object {
        const val IMAGES = 26
    }
}
