package robotran.tinyvm.run

import robotran.rom.SensorCode

/** What the program last said of a sensor: leJOS sets type and mode one after the other, the ROM takes both. */
internal class SensorSettings {
    var type = SensorCode.TYPE_LIGHT
    var mode = SensorCode.MODE_PERCENT
}
