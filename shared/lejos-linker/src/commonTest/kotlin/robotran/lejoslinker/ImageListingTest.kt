package robotran.lejoslinker

import robotran.language.Language
import robotran.lejoslinker.listing.listingOf
import robotran.lejoslinker.messages.ListingMessages
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertIs

class ImageListingTest {
    private fun listing(name: String, language: Language = Language.ENGLISH): List<String> {
        val image = assertIs<ImageResult.Success>(linkVector(name)).image
        return listingOf(image, ListingMessages.of(language)).trimEnd('\n').lines()
    }

    @Test
    fun `the parts of an image follow each other`() {
        val lines = listing("Square")
        assertEquals(
            listOf(
                "An image of 3333 bytes:",
                "  head  16 bytes at 0",
                "  class records  280 bytes at 16",
                "  static state  72 bytes at 296",
                "  static field records  36 bytes at 368",
                "  constant records  128 bytes at 404",
                "  method records  1092 bytes at 532",
            ),
            lines.take(7),
        )
        assertContains(lines, "  programs  1 byte at 3332")
    }

    @Test
    fun `classes have their methods with the numbers of the brick`() {
        val lines = listing("Square")
        assertContains(lines, "  1 java.lang.Thread: java.lang.Object  objects of 36 bytes")
        assertContains(lines, "    3 sleep(J)V  static  native")
        assertContains(lines, "    1 toString()Ljava/lang/String;  3 bytes at 1646")
        assertContains(lines, "  55 penDown()V")
    }

    @Test
    fun `constants are shown as in Java`() {
        val image = assertIs<ImageResult.Success>(
            linkMain {
                addMain()
                string("a \"quote\"\n")
                number(100_000)
            },
        ).image
        val lines = listingOf(image, messages = ListingMessages.of(Language.ENGLISH)).lines().map {
            it.trim().substringAfter(' ')
        }
        assertContains(lines, "\"a \\\"quote\\\"\\u000a\"")
        assertContains(lines, "int 100000")
    }

    @Test
    fun `other languages have their own words and the same numbers`() {
        assertEquals("Ein Abbild von 3333 Bytes:", listing("Square", Language.GERMAN).first())
        assertEquals("Una imagen de 3333 bytes:", listing("Square", Language.SPANISH).first())
    }
}
