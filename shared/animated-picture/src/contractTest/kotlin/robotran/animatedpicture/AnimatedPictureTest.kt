package robotran.animatedpicture

import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith
import kotlin.test.assertIs

class AnimatedPictureTest {
    @Test
    fun `progress counts every frame and ends with the file`() {
        val steps = animatedGif(TestFrames(2, List(20) { IntArray(4) { place -> place * it } })).toList()
        assertEquals((1..28).map { AnimationStep.Progress(it, 28) }, steps.dropLast(1))
        assertIs<AnimationStep.Finished>(steps.last())
    }

    @Test
    fun `nothing is drawn before it is asked for`() {
        val drawn = mutableListOf<Int>()
        val source = object : FrameSource by TestFrames(1, List(100) { intArrayOf(it) }) {
            override fun draw(index: Int, pixels: IntArray) {
                drawn += index
            }
        }
        assertEquals(3, animatedGif(source).take(3).count())
        assertEquals(3, drawn.size)
    }

    @Test
    fun `the bytes are those of the format's specification`() {
        val bytes = gifOf(TestFrames(2, listOf(intArrayOf(0xFF0000, 0, 0, 0xFFFFFF), intArrayOf(0xFF0000, 0, 0, 0))))
        val expected = listOf(
            "474946383961 0200 0200 f1 00 00", // GIF89a, 2 x 2 pixels, a table of 4 colours
            "000000 ff0000 ffffff 000000",
            "21ff0b 4e45545343415045322e30 03 01 0000 00", // NETSCAPE2.0: for ever
            "21f904 05 0800 03 00 2c 0000 0000 0200 0200 00", // for 80 ms, all of it
            "02 03 0c2005 00",
            "21f904 05 d000 03 00 2c 0100 0100 0100 0100 00", // for 2080 ms, the lower right pixel
            "02 02 4401 00",
            "3b",
        )
        assertEquals(expected.joinToString("").replace(" ", ""), bytes.toHexString())
    }

    @Test
    fun `a source beyond the limits is a mistake of the caller`() {
        val wide = TestFrames(AnimatedPictureLimits.MAX_SIDE + 1, listOf(IntArray(AnimatedPictureLimits.MAX_SIDE + 1)))
        val long = TestFrames(1, List(AnimatedPictureLimits.MAX_FRAMES + 1) { IntArray(1) })
        val uneven = TestFrames(1, listOf(IntArray(1)), frameMilliseconds = 15)
        for (source in listOf(wide, long, uneven)) {
            assertFailsWith<IllegalArgumentException> { animatedGif(source).first() }
        }
    }
}
