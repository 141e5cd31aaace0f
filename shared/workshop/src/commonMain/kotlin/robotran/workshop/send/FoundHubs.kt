package robotran.workshop.send

import robotran.brick.kind.BrickKind
import robotran.hub.model.HubModel
import robotran.hublink.HubKind
import robotran.hublink.hub.HubState
import robotran.workshop.state.FoundHub

/** What the screen tells of a connected hub, [state]; [brick] is that of the program's robot. */
internal fun foundHub(state: HubState, brick: BrickKind): FoundHub? {
    val hub = state.description ?: return null
    val model = hub.kind.model
    return FoundHub(
        hub.name,
        hub.kind.productName,
        "${hub.firmware}",
        hub.programRoom,
        isBatteryLow = state.status?.isBatteryLow == true,
        hub.isNewerThanKnown,
        // An unknown hub may be a newer one that does.
        expected = brick.label.takeIf { hub.kind != HubKind.UNKNOWN && model != HubModel.of(brick) },
    )
}

/** The hub that programs are written for; null for one that has none of its own. */
private val HubKind.model: HubModel?
    get() = when (this) {
        HubKind.SPIKE_PRIME, HubKind.ROBOT_INVENTOR -> HubModel.SPIKE_PRIME
        HubKind.SPIKE_ESSENTIAL -> HubModel.SPIKE_ESSENTIAL
        HubKind.TECHNIC -> HubModel.TECHNIC_HUB
        HubKind.EV3 -> HubModel.EV3
        HubKind.NXT -> HubModel.NXT_PYBRICKS
        HubKind.CITY, HubKind.MOVE, HubKind.UNKNOWN -> null
    }
