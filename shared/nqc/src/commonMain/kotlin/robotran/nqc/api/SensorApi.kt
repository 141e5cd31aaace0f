package robotran.nqc.api

import robotran.nqc.config.ParameterLimit.SENSOR_TYPE

/** Sensors. The argument `__sensor(n)` of a value is a number or a sensor such as `SENSOR_1`. */
internal val SENSOR_API = api(NqcApiGroup.SENSORS) {
    function(
        "SetSensor(__sensor sensor, const int kind)",
        "SetSensorType(sensor, kind >> 8); SetSensorMode(sensor, kind);",
        ApiHelp(
            "Says what is connected to a sensor port: SENSOR_TOUCH, SENSOR_LIGHT, SENSOR_ROTATION and so on.",
            "Sagt, was an einem Sensoreingang steckt: SENSOR_TOUCH, SENSOR_LIGHT, SENSOR_ROTATION und so weiter.",
            "Dice qué hay conectado a una entrada: SENSOR_TOUCH, SENSOR_LIGHT, SENSOR_ROTATION, etc.",
        ),
    )
    function(
        "SetSensorType(__sensor sensor, const int type)",
        "asm { 0x32, \$sensor : 0x3000200, type };",
        ApiHelp(
            "Sets the type of a sensor, such as SENSOR_TYPE_LIGHT.",
            "Stellt die Art eines Sensors ein, etwa SENSOR_TYPE_LIGHT.",
            "Ajusta el tipo de un sensor, como SENSOR_TYPE_LIGHT.",
        ),
        null,
        SENSOR_TYPE,
    )
    function(
        "SetSensorMode(__sensor sensor, const int mode)",
        "asm { 0x42, \$sensor : 0x3000200, mode };",
        ApiHelp(
            "Sets how a sensor's value is computed, such as SENSOR_MODE_PERCENT, and sets it to zero.",
            "Stellt ein, wie der Wert eines Sensors berechnet wird, etwa SENSOR_MODE_PERCENT, und setzt ihn auf null.",
            "Ajusta cómo se calcula el valor de un sensor, como SENSOR_MODE_PERCENT, y lo pone a cero.",
        ),
    )
    function(
        "ClearSensor(__sensor sensor)",
        "asm { 0xd1, \$sensor : 0x3000200 };",
        ApiHelp(
            "Sets a rotation or counting sensor to zero.",
            "Setzt einen Drehsensor oder zählenden Sensor auf null.",
            "Pone a cero un sensor de rotación o que cuenta.",
        ),
    )
    value(
        "SensorValue(n)",
        "@(0x90000 + (__sensor(n)))",
        ApiHelp(
            "The value of sensor 0, 1 or 2; SENSOR_1 is the same as SensorValue(0).",
            "Der Wert von Sensor 0, 1 oder 2; SENSOR_1 ist dasselbe wie SensorValue(0).",
            "El valor del sensor 0, 1 o 2; SENSOR_1 es lo mismo que SensorValue(0).",
        ),
    )
    value(
        "SensorType(n)",
        "@(0xa0000 + (__sensor(n)))",
        ApiHelp("The type of a sensor.", "Die Art eines Sensors.", "El tipo de un sensor."),
    )
    value(
        "SensorMode(n)",
        "@(0xb0000 + (__sensor(n)))",
        ApiHelp("The mode of a sensor.", "Der Modus eines Sensors.", "El modo de un sensor."),
    )
    value(
        "SensorValueRaw(n)",
        "@(0xc0000 + (__sensor(n)))",
        ApiHelp(
            "What the brick measures at a sensor port, 0 to 1023.",
            "Was der Stein an einem Sensoreingang misst, 0 bis 1023.",
            "Lo que el ladrillo mide en una entrada, de 0 a 1023.",
        ),
    )
    value(
        "SensorValueBool(n)",
        "@(0xd0000 + (__sensor(n)))",
        ApiHelp(
            "1 if a sensor is pressed or low, else 0.",
            "1, wenn ein Sensor gedrückt oder niedrig ist, sonst 0.",
            "1 si un sensor está pulsado o bajo; si no, 0.",
        ),
    )
    val sensor = ApiHelp("A sensor and its value.", "Ein Sensor und sein Wert.", "Un sensor y su valor.")
    value("SENSOR_1", "SensorValue(0)", sensor)
    value("SENSOR_2", "SensorValue(1)", sensor)
    value("SENSOR_3", "SensorValue(2)", sensor)
    constants(
        "S1=0 S2=1 S3=2",
        ApiHelp("The number of a sensor.", "Die Nummer eines Sensors.", "El número de un sensor."),
    )
    constants(
        "SENSOR_TYPE_NONE=0 SENSOR_TYPE_TOUCH=1 SENSOR_TYPE_TEMPERATURE=2 SENSOR_TYPE_LIGHT=3 SENSOR_TYPE_ROTATION=4",
        ApiHelp("A type of sensors.", "Eine Art von Sensoren.", "Un tipo de sensores."),
    )
    constants(
        "SENSOR_MODE_RAW=0 SENSOR_MODE_BOOL=0x20 SENSOR_MODE_EDGE=0x40 SENSOR_MODE_PULSE=0x60 " +
            "SENSOR_MODE_PERCENT=0x80 SENSOR_MODE_CELSIUS=0xa0 SENSOR_MODE_FAHRENHEIT=0xc0 SENSOR_MODE_ROTATION=0xe0",
        ApiHelp(
            "How a sensor's value is computed.",
            "Wie der Wert eines Sensors berechnet wird.",
            "Cómo se calcula el valor de un sensor.",
        ),
    )
    constants(
        "SENSOR_TOUCH=0x120 SENSOR_LIGHT=0x380 SENSOR_ROTATION=0x4e0 SENSOR_CELSIUS=0x2a0 SENSOR_FAHRENHEIT=0x2c0 " +
            "SENSOR_PULSE=0x160 SENSOR_EDGE=0x140",
        ApiHelp(
            "A kind of sensor for SetSensor.",
            "Eine Sensorart für SetSensor.",
            "Una clase de sensor para SetSensor.",
        ),
    )
}
