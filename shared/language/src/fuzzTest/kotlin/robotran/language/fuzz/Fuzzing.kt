package robotran.language.fuzz

import java.io.File
import kotlin.random.Random

/**
 * How many inputs the tests of this process try, and which: the tasks of the build say so, see `FuzzTests` in
 * `gradle/build-logic`. Without the build, it is what `jvmTest` tries.
 */
object Fuzzing {
    /** Other inputs for another number. Kotest's property tests take it from the same property. */
    val seed: Long = System.getProperty("kotest.proptest.default.seed")?.toLong() ?: 2005

    private val percent = Integer.getInteger("robotran.fuzz.percent", 3)
    private val task = System.getProperty("robotran.fuzz.task")

    /** Of [all] inputs, as many as this process tries: all in `fuzzTest`; in `jvmTest` a few per cent, or [atLeast]. */
    fun share(all: Int, atLeast: Int = 1): Int = maxOf(atLeast, all * percent / 100)

    /**
     * Calls [check] for the [share] of [all] numbers, each with its own random numbers, and returns for how many it is
     * true. When it fails, it says how to repeat the failure.
     */
    fun count(all: Int, check: (Random) -> Boolean): Int = (1..share(all)).count { number ->
        try {
            check(Random(seed + number))
        } catch (failure: Throwable) {
            throw AssertionError(
                "$failure, with input $number: ./gradlew $task -PpropertySeed=$seed repeats it",
                failure,
            )
        }
    }

    /** The inputs that once found a fault: the files of the module's `src/jvmTest/resources/corpus` with [ending]. */
    fun corpus(ending: String): Map<String, ByteArray> {
        val folder = File(checkNotNull(javaClass.getResource("/corpus")) { "The module has no corpus." }.toURI())
        val files = folder.listFiles().orEmpty().filter { it.name.endsWith(ending) }
        check(files.isNotEmpty()) { "No file in $folder ends with $ending." }
        return files.associate { it.name to it.readBytes() }
    }

    /** Those that are texts. */
    fun corpusTexts(ending: String): Map<String, String> = corpus(ending).mapValues { it.value.decodeToString() }
}
