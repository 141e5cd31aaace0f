package robotran.ui.run.tags

import robotran.brick.controls.BrickButton
import robotran.brick.log.CallGroup
import robotran.runcontrol.ChartLane
import robotran.runcontrol.RunSpeed
import robotran.workshop.state.DrawerTab

/** The tags of the room of a run, by which tests and the page find what is on the screen. */
object RunTags {
    const val ANNOUNCER = "announcer"
    const val BESIDE = "beside"
    const val BESIDE_CLOSE = "beside-close"
    const val BRICK = "brick"
    const val BRICK_HINT = "brick-hint"
    const val BRICK_HINT_CLOSE = "brick-hint-close"
    const val CHART_COARSER = "chart-coarser"
    const val CHART_FINER = "chart-finer"
    const val CHART_TIME = "chart-time"
    const val CLOCK = "clock"
    const val DATALOG = "datalog"
    const val DATALOG_SAVE = "datalog-save"
    const val DRAWER = "drawer"
    const val DRAWER_CLOSE = "drawer-close"
    const val DRAWER_EMPTY = "drawer-empty"
    const val DRAWER_GRIP = "drawer-grip"
    const val DRAWER_TWO = "drawer-two"
    const val EXCEPTION_CALLS = "exception-calls"
    const val GOAL = "goal"
    const val GOALS_TASK = "goals-task"
    const val GOAL_CHIP = "goal-chip"
    const val INFLUENCE = "influence"
    const val JAVA_FAST = "java-fast"
    const val JAVA_FORGIVING = "java-forgiving"
    const val LCD = "lcd"
    const val LOG = "log"
    const val LOG_COPY = "log-copy"
    const val LOG_COUNT = "log-count"
    const val LOG_PROGRAM = "log-program"
    const val LOG_SAVE = "log-save"
    const val LOG_SEARCH = "log-search"
    const val LOG_TROUBLED = "log-troubled"
    const val MARK_NEXT = "mark-next"
    const val MARK_PREVIOUS = "mark-previous"
    const val PANEL_STEP_OUT = "panel-step-out"
    const val PANEL_STEP_OVER = "panel-step-over"
    const val PANEL_TO_LINE = "panel-to-line"
    const val PAUSE = "pause"
    const val PLAY_RECORDING = "play-recording"
    const val REALISM = "realism"
    const val RUN = "run"
    const val RUN_MORE = "run-more"
    const val RUN_PANEL = "run-panel"
    const val RUN_PANEL_CLOSE = "run-panel-close"
    const val SEED = "seed"
    const val SEED_NEXT = "seed-next"
    const val SHORTFALL = "shortfall"
    const val SHORTFALL_TEXT = "shortfall-text"
    const val SOUND = "sound"
    const val SPEED = "speed"
    const val START_OVER = "start-over"
    const val STATUS = "status"
    const val STEP = "step"
    const val STEPS = "steps"
    const val STEP_INTO = "step-into"
    const val STEP_OUT = "step-out"
    const val STEP_OVER = "step-over"
    const val STEP_TO_LINE = "step-to-line"
    const val STOP = "stop"
    const val TASK_CHIP = "task-chip"
    const val TIMELINE = "timeline"
    const val WHY_REMARK = "why-remark"

    fun button(button: BrickButton) = "brick-${button.name.lowercase()}"

    fun chart(lane: ChartLane) = "chart-${lane.name.lowercase()}"

    fun datalog(number: Int) = "datalog-$number"

    fun frame(index: Int) = "frame-$index"

    fun lane(lane: ChartLane) = "lane-${lane.name.lowercase()}"

    fun log(group: CallGroup) = "log-${group.name.lowercase()}"

    fun names(tag: String) = "$tag-names"

    fun panel(tab: DrawerTab) = "panel-${tab.name.lowercase()}"

    fun panelSpeed(speed: RunSpeed) = "panel-speed-${speed.name.lowercase()}"

    fun port(sensor: Int) = "port-$sensor"

    fun port(motor: String) = "port-$motor"

    fun robot(number: Int) = "robot-$number"

    fun speed(speed: RunSpeed) = "speed-${speed.name.lowercase()}"

    fun tab(tag: String, tab: DrawerTab) = "$tag-${tab.name.lowercase()}"

    fun thread(number: Int) = "thread-$number"

    fun value(lane: ChartLane) = "value-${lane.name.lowercase()}"

    fun variable(name: String) = "variable-$name"
}
