package robotran.assignments.reporting

import robotran.assignments.grading.Verdict
import robotran.assignments.messages.ReportMessages

/** [verdict] in a word or two. */
fun ReportMessages.verdict(verdict: Verdict): String = when (verdict) {
    Verdict.PASSED -> solved()
    Verdict.PARTLY -> partlySolved()
    Verdict.MISSED -> notSolved()
    Verdict.MISTAKES -> hasMistakes()
    Verdict.FAILED -> notGraded()
    Verdict.UNUSABLE -> unusable()
}
