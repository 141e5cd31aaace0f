package robotran.hub.model

/**
 * What Pybricks has for the motors and sensors of a hub.
 *
 * @property module its module with their classes.
 * @property choosesColors whether a program chooses the colours that a colour sensor tells apart.
 * @property awaitsColor whether a task has to await what a colour sensor reads.
 * @property hasWholeLight whether its light is whole numbers also where others measure decimal ones.
 * @property colors what a colour sensor tells apart until a program says otherwise.
 */
enum class HubDevices(
    val module: String,
    val choosesColors: Boolean,
    val awaitsColor: Boolean,
    val hasWholeLight: Boolean,
    val colors: List<HubColor> = HubColor.DETECTABLE,
) {
    POWERED_UP("pybricks.pupdevices", choosesColors = true, awaitsColor = true, hasWholeLight = false),
    EV3(
        "pybricks.ev3devices",
        choosesColors = false,
        awaitsColor = true,
        hasWholeLight = true,
        colors = HubColor.DETECTABLE + HubColor.BLACK + HubColor.BROWN,
    ),
    NXT("pybricks.nxtdevices", choosesColors = true, awaitsColor = false, hasWholeLight = false),
}
