package robotran.hub

import robotran.hub.model.HubModel
import kotlin.test.Test
import kotlin.test.assertEquals

/** What a hub says about itself agrees with what all of Robotran knows of it. */
class HubModelTest {
    @Test
    fun `ports and buttons of a hub are those of its kind`() {
        for (model in HubModel.entries) {
            val kind = model.kind
            assertEquals(kind.motorPorts, model.motorPorts.map { it.motorPort }, "$model")
            assertEquals(kind.buttons, model.buttons.map { it.control }, "$model")
            val labels = List(kind.inputPorts) { kind.inputLabel(it + 1) }
            assertEquals(labels, model.sensorPorts.map { it.name.removePrefix("S") }, "$model")
            assertEquals(model, HubModel.of(kind))
        }
    }
}
