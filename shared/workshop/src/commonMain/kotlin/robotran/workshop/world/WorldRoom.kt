package robotran.workshop.world

import robotran.workshop.event.RobotEditEvent
import robotran.workshop.event.SheetEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.event.WorldEvent
import robotran.workshop.service.RoomEvent
import robotran.workshop.service.Services
import robotran.workshop.sheet.SheetStateHolder

/**
 * The room with the sheet and the editors of the world and its robots.
 *
 * @param isLocked whether the open assignment does not allow to change its world.
 */
internal class WorldRoom(services: Services, isLocked: () -> Boolean) {
    val sheet = SheetStateHolder(services.preferences)
    val editors = WorldEditors(services, isLocked)

    fun on(event: RoomEvent) {
        editors.on(event)
        sheet.on(event)
    }

    fun handle(event: WorldEvent) {
        when (event) {
            is SheetEvent -> sheet.handle(event)
            is WorldEditEvent -> editors.handle(event)
            is RobotEditEvent -> editors.handle(event)
        }
    }
}
