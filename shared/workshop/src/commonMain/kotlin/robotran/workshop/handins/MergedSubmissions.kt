package robotran.workshop.handins

import robotran.assignments.collecting.Submission
import robotran.assignments.collecting.countingOf
import robotran.assignments.collecting.keyOf
import robotran.documents.FileStamp

/**
 * Hand-ins that were brought in one batch after the other. The same batches in the same order give the same IDs, also
 * if some hand-ins were removed meanwhile.
 */
internal class MergedSubmissions {
    /** By ID, in the order in which they were brought in. */
    private val found = LinkedHashMap<String, Entry>()

    /** By ID, without those that were removed. */
    val all: Map<String, Submission>
        get() = found.filterValues { !it.isRemoved }.mapValues { it.value.submission }

    /** The IDs of what was removed. */
    val removedIds: Set<String> get() = found.filterValues { it.isRemoved }.keys

    /** The stamps of what was removed. */
    val removed: Set<String> get() = found.values.filter { it.isRemoved }.flatMapTo(mutableSetOf()) { it.stamps }

    /**
     * Adds [batch]. Content that is there already does not count twice. Of hand-ins of the same pupil from the same source,
     * [countingOf] says which counts. What was removed and is brought in again is there again.
     *
     * @return those that were not there.
     */
    fun add(batch: List<Submission>): List<Submission> = batch.filter(::isNew)

    /** Removes the hand-in [id]; with [isRemoved] false, it is there again. */
    fun remove(id: String, isRemoved: Boolean = true) {
        found[id]?.isRemoved = isRemoved
    }

    /** Removes each hand-in of which everything is in [stamps]. */
    fun removeAll(stamps: Set<String>) = found.values.filter { stamps.containsAll(it.stamps) }.forEach {
        it.isRemoved = true
    }

    private fun isNew(submission: Submission): Boolean {
        val stamp = stampOf(submission)
        found.values.firstOrNull { stamp in it.stamps }?.let { known ->
            return known.isRemoved.also { known.isRemoved = false }
        }
        val earlier = found.values.firstOrNull { isLater(submission, of = it.submission) }
        if (earlier == null) {
            found[newId(submission.name)] = Entry(submission, mutableSetOf(stamp))
        } else {
            earlier.add(submission, stamp)
        }
        return true
    }

    private fun newId(name: String): String =
        generateSequence(1) { it + 1 }.map { if (it == 1) name else "$name $it" }.first { it !in found }

    private class Entry(var submission: Submission, val stamps: MutableSet<String>) {
        var isRemoved = false

        fun add(other: Submission, stamp: String) {
            submission = countingOf(listOf(submission, other))
            stamps += stamp
            isRemoved = false
        }
    }
}

/** The same for the same content of the same name, wherever it came from. */
private fun stampOf(submission: Submission): String = FileStamp.of(
    when (submission) {
        is Submission.Unusable -> listOf(submission.name, submission.origin, submission.reason)

        is Submission.Usable -> listOf(keyOf(submission.name), submission.handIn?.hash.orEmpty()) +
            submission.robot.programs.flatMap { it.files }.flatMap { listOf(it.name, it.text) }
    }.joinToString("\u0000"),
).text

/** Programs without a name from the app may be anybody's. Two pupils may have one name, but not one source. */
private fun isLater(one: Submission, of: Submission): Boolean =
    keyOf(one.name) == keyOf(of.name) && isSameSource(one.origin, of.origin) &&
        (of is Submission.Unusable || (triesOf(one) != null && triesOf(of) != null))

/** A pupil's folder is the source of the files in it, too. */
private fun isSameSource(one: String, other: String): Boolean =
    one == other || one.startsWith("$other/") || other.startsWith("$one/")

private fun triesOf(submission: Submission): Int? = (submission as? Submission.Usable)?.handIn?.tries
