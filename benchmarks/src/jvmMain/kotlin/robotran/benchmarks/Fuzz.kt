package robotran.benchmarks

import robotran.robolang.fuzz.anyText
import robotran.robolang.fuzz.checkHarmless
import kotlin.random.Random
import kotlin.system.exitProcess
import kotlin.time.DurationUnit
import kotlin.time.TimeSource

/**
 * Compiles, formats and runs random texts: the first of [arguments] is their number, the second the seed. The long form
 * of the fuzz tests. Prints the seed, and each text that caused an error.
 */
internal fun fuzz(arguments: List<String>) {
    val count = arguments.getOrNull(0)?.toIntOrNull() ?: DEFAULT_COUNT
    val seed = arguments.getOrNull(1)?.toLongOrNull() ?: System.nanoTime()
    println("fuzz: $count texts, seed $seed")
    val begun = TimeSource.Monotonic.markNow()
    repeat(count) { number ->
        val text = anyText(Random(seed + number))
        try {
            checkHarmless(text)
        } catch (
            @Suppress("TooGenericExceptionCaught") failure: Throwable,
        ) {
            System.err.println("Text $number of seed $seed does harm, $failure:\n$text")
            exitProcess(1)
        }
    }
    val seconds = begun.elapsedNow().toDouble(DurationUnit.SECONDS)
    println("fuzz: no harm done, %.0f texts a second".format(count / seconds))
}

private const val DEFAULT_COUNT = 2_000_000
