package robotran.assignments.messages

import robotran.language.listed

internal object EnglishReportMessages : ReportMessages {
    override fun columns(worlds: Int) = listOf(
        "name",
        "verdict",
        "goals met",
        "goals",
        if (worlds == 1) "seeds met" else "seeds met (all worlds)",
        if (worlds == 1) "seeds" else "seeds (all worlds)",
        "seconds",
        "lines",
        "tries",
        "remarks",
        "goals met in all runs",
        "nearly the same program",
        "comment",
    )

    override fun assignment() = "assignment"

    override fun meanSeconds() = "seconds (mean)"

    override fun solved() = "solved"

    override fun partlySolved() = "partly solved"

    override fun notSolved() = "not solved"

    override fun hasMistakes() = "has mistakes"

    override fun notGraded() = "not graded"

    override fun unusable() = "cannot be used"

    override fun countOf(some: Int, all: Int) = "$some of $all"

    override fun summary(handIns: Int, passed: Int) = "$passed of $handIns hand-ins are solved."

    override fun runsMet(some: Int, all: Int) = if (all == 1) {
        if (some == 1) "Reached all goals." else "Did not reach all goals."
    } else {
        "Reached all goals in $some of $all runs."
    }

    override fun plan(worlds: Int, firstSeed: Int, lastSeed: Int): String {
        val seeds = if (firstSeed == lastSeed) "the seed $firstSeed" else "the seeds $firstSeed to $lastSeed"
        return if (worlds == 1) "Each was run with $seeds." else "Each was run in $worlds worlds with $seeds."
    }

    override fun ownWorld() = "As given"

    override fun goal() = "goal"

    override fun seedsMet() = "seeds met"

    override fun missedWith(seeds: String) = "missed with seed $seeds"

    override fun similarHandIns() = "Similar hand-ins"

    override fun similar(names: List<String>, percent: Int) =
        "${listed(names, "and")} have at least $percent % of their programs in common."

    override fun equal(names: List<String>) = "${listed(names, "and")} have the same program."

    override fun remarks() = "Remarks"

    override fun programs() = "Program"

    override fun comment() = "Comment"

    override fun feedback() = "feedback"

    override fun nothingToGrade() = "Robotran found nothing of yours that it can grade."

    override fun notHandIns() = "Not hand-ins"

    override fun shortened() = "(The rest is not shown.)"
}
