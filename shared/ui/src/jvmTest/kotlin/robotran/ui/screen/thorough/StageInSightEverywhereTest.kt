package robotran.ui.screen.thorough

import robotran.ui.screen.StageInSight

class StageInSightEverywhereTest : StageInSight() {
    override fun windowsOf(number: Int): List<Pair<Int, Int>> = WINDOWS
}
