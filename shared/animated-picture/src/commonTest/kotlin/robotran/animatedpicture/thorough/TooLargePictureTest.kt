package robotran.animatedpicture.thorough

import robotran.animatedpicture.AnimatedPictureLimits
import robotran.animatedpicture.AnimationStep
import robotran.animatedpicture.FrameSource
import robotran.animatedpicture.animatedGif
import kotlin.test.Test
import kotlin.test.assertEquals

class TooLargePictureTest {
    @Test
    fun `a picture that would be too large to send is given up`() {
        val side = AnimatedPictureLimits.MAX_SIDE
        // A linear congruential generator: such noise cannot be compressed.
        var noise = 1
        val source = object : FrameSource {
            override val width = side
            override val height = side
            override val count = 18
            override val frameMilliseconds = 80

            override fun draw(index: Int, pixels: IntArray) {
                for (place in pixels.indices) {
                    noise = noise * 1_103_515_245 + 12_345
                    pixels[place] = noise ushr 8
                }
            }
        }
        assertEquals(AnimationStep.TooLarge, animatedGif(source).last())
    }
}
