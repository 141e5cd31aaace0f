package robotran.world.file

import robotran.language.Language
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertTrue

/** Damaged files always give a consistent result. */
class BrokenWorldTest {
    private val files = (BuiltInWorlds.texts.values + FULL_WORLD).map { it.encodeToByteArray() }

    @Test
    fun `a file cut off at any byte is refused`() {
        for (file in files) {
            for (length in 0..<file.indexOfLast { it == '}'.code.toByte() }) {
                assertTrue(
                    readWorld(file.copyOf(length), Language.ENGLISH) is WorldFileResult.Failure,
                    "cut off at $length",
                )
            }
        }
    }

    @Test
    fun `a file with any byte changed gives a result that holds`() {
        val random = Random(2005)
        for (file in files) {
            repeat(MUTATIONS) {
                val changed = file.copyOf()
                repeat(random.nextInt(1, 4)) { changed[random.nextInt(changed.size)] = random.nextInt(256).toByte() }
                holds(readWorld(changed, Language.ENGLISH))
            }
        }
    }

    @Test
    fun `a file with any piece put elsewhere gives a result that holds`() {
        val random = Random(2005)
        for (file in files.map { it.decodeToString() }) {
            repeat(MUTATIONS) {
                val from = random.nextInt(file.length)
                val piece = file.substring(from, minOf(file.length, from + random.nextInt(40)))
                val to = random.nextInt(file.length)
                holds(
                    readWorld(
                        file.replaceRange(to, minOf(file.length, to + random.nextInt(40)), piece),
                        Language.ENGLISH,
                    ),
                )
            }
        }
    }

    private companion object {
        const val MUTATIONS = 1000
    }
}
