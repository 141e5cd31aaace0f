package robotran.nqc.api

import robotran.nqc.config.ParameterLimit.OUTPUTS
import robotran.nqc.config.ParameterLimit.POWER
import robotran.nqc.config.ParameterLimit.SOUND
import robotran.nqc.config.ParameterLimit.TIMER
import robotran.nqc.config.ParameterLimit.TONE_TIME
import robotran.nqc.config.ParameterLimit.WAIT

/** The API of NQC 1.3, which programs from 1998 and 1999 use. */
internal val OLD_API: List<NqcApiEntry> = oldOutputs() + oldSensors() + oldOthers()

private fun oldOutputs() = api(NqcApiGroup.OUTPUTS) {
    val mode =
        ApiHelp("Sets the mode of motors.", "Stellt den Modus von Motoren ein.", "Ajusta el modo de los motores.")
    function("OutputMode(const int outputs, const int mode)", "asm { 0x21, outputs + mode };", mode, OUTPUTS)
    val direction =
        ApiHelp(
            "Sets the direction of motors.",
            "Stellt die Richtung von Motoren ein.",
            "Ajusta la dirección de los motores.",
        )
    function(
        "OutputDir(const int outputs, const int direction)",
        "asm { 0xe1, outputs + direction };",
        direction,
        OUTPUTS,
    )
    val power =
        ApiHelp(
            "Sets the power of motors.",
            "Stellt die Leistung von Motoren ein.",
            "Ajusta la potencia de los motores.",
        )
    function(
        "OutputPower(const int outputs, const int &power)",
        "asm { 0x13, outputs, \$power : 0x1000015 };",
        power,
        OUTPUTS,
        POWER,
    )
    function(
        "Fwd(const int outputs, const int &power)",
        "OutputDir(outputs, 0x80); OutputMode(outputs, 0x80); OutputPower(outputs, power);",
        ApiHelp(
            "Switches motors on, forward, with a power.",
            "Schaltet Motoren vorwärts ein, mit einer Leistung.",
            "Enciende motores hacia adelante con una potencia.",
        ),
        OUTPUTS,
        POWER,
    )
    function(
        "Rev(const int outputs, const int &power)",
        "OutputDir(outputs, 0); OutputMode(outputs, 0x80); OutputPower(outputs, power);",
        ApiHelp(
            "Switches motors on, backward, with a power.",
            "Schaltet Motoren rückwärts ein, mit einer Leistung.",
            "Enciende motores hacia atrás con una potencia.",
        ),
        OUTPUTS,
        POWER,
    )
    val off =
        ApiHelp("Stops motors and brakes them.", "Hält Motoren an und bremst sie.", "Para los motores y los frena.")
    function("Off(const int outputs)", "OutputMode(outputs, 0x40);", off, OUTPUTS)
    val float = ApiHelp("Lets motors roll on.", "Lässt Motoren ausrollen.", "Deja rodar los motores.")
    function("Float(const int outputs)", "OutputMode(outputs, 0);", float, OUTPUTS)
    val toggle =
        ApiHelp(
            "Turns the direction of motors round.",
            "Kehrt die Richtung von Motoren um.",
            "Invierte la dirección de los motores.",
        )
    function("Toggle(const int outputs)", "OutputDir(outputs, 0x40);", toggle, OUTPUTS)
    constants(
        "OUT_A=1 OUT_B=2 OUT_C=4",
        ApiHelp("A motor.", "Ein Motor.", "Un motor."),
    )
    constants(
        "OUT_FLOAT=0 OUT_OFF=0x40 OUT_ON=0x80 OUT_REV=0 OUT_FLIP=0x40 OUT_FWD=0x80 OUT_LOW=1 OUT_HALF=4 OUT_FULL=7",
        ApiHelp("A setting of motors.", "Eine Einstellung von Motoren.", "Un ajuste de los motores."),
    )
}

private fun oldSensors() = api(NqcApiGroup.SENSORS) {
    val sensor = ApiHelp("A sensor and its value.", "Ein Sensor und sein Wert.", "Un sensor y su valor.")
    value("IN_1", "Input(0)", sensor)
    value("IN_2", "Input(1)", sensor)
    value("IN_3", "Input(2)", sensor)
    value("Input(n)", "@(0x90000 + (n))", sensor)
    val type = ApiHelp("The type of a sensor.", "Die Art eines Sensors.", "El tipo de un sensor.")
    value("InputType(n)", "@(0xa0000 + (n))", type)
    val mode = ApiHelp("The mode of a sensor.", "Der Modus eines Sensors.", "El modo de un sensor.")
    value("InputMode(n)", "@(0xb0000 + (n))", mode)
    val raw = ApiHelp("The raw value of a sensor.", "Der Rohwert eines Sensors.", "El valor sin tratar de un sensor.")
    value("InputRaw(n)", "@(0xc0000 + (n))", raw)
    val bool = ApiHelp("1 if a sensor is pressed.", "1, wenn ein Sensor gedrückt ist.", "1 si un sensor está pulsado.")
    value("InputBool(n)", "@(0xd0000 + (n))", bool)
    val settings = ApiHelp(
        "Says what is connected to a sensor port, such as IN_LIGHT.",
        "Sagt, was an einem Sensoreingang steckt, etwa IN_LIGHT.",
        "Dice qué hay conectado a una entrada, como IN_LIGHT.",
    )
    function("SensorType(__sensor sensor, const int type)", "asm { 0x32, \$sensor : 0x3000200, type };", settings)
    function("SensorMode(__sensor sensor, const int mode)", "asm { 0x42, \$sensor : 0x3000200, mode };", settings)
    function(
        "Sensor(__sensor sensor, const int kind)",
        "SensorType(sensor, kind >> 8); SensorMode(sensor, kind);",
        settings,
    )
    val clear = ApiHelp("Sets a sensor to zero.", "Setzt einen Sensor auf null.", "Pone a cero un sensor.")
    function("ClearSensor(__sensor sensor)", "asm { 0xd1, \$sensor : 0x3000200 };", clear)
    constants(
        "SMODE_RAW=0 SMODE_BOOL=0x20 SMODE_EDGE=0x40 SMODE_PULSE=0x60 SMODE_PERCENT=0x80 SMODE_CELSIUS=0xa0 " +
            "SMODE_FAHRENHEIT=0xc0 SMODE_ANGLE=0xe0",
        mode,
    )
    constants("STYPE_SWITCH=1 STYPE_TEMP=2 STYPE_LIGHT=3 STYPE_ANGLE=4", type)
    value("IN_CFG(type, mode)", "(((type) << 8) + (mode))", settings)
    constants("IN_SWITCH=0x120 IN_PULSE=0x160 IN_EDGE=0x140 IN_LIGHT=0x380 IN_ANGLE=0x4e0", settings)
}

private fun oldOthers() = api(NqcApiGroup.OTHER) {
    val timer =
        ApiHelp(
            "A timer in tenths of a second.",
            "Ein Timer in Zehntelsekunden.",
            "Un temporizador en décimas de segundo.",
        )
    value("Timer(n)", "@(0x10000 + (n))", timer)
    function("ClearTimer(const int n)", "asm { 0xa1, n };", timer, TIMER)
    val random = ApiHelp("A random number from 0 to n.", "Eine Zufallszahl von 0 bis n.", "Un número al azar de 0 a n.")
    value("Random(n)", "@(0x40000 + (n))", random)
    val program = ApiHelp("The number of this program.", "Die Nummer dieses Programms.", "El número de este programa.")
    value("Program()", "@(0x80000)", program)
    val watch = ApiHelp("The brick's clock.", "Die Uhr des Steins.", "El reloj del ladrillo.")
    value("Watch()", "@(0xe0000)", watch)
    function("SetWatch(const int hours, const int minutes)", "asm { 0x22, hours, minutes };", watch)
    val message = ApiHelp("Messages between bricks.", "Nachrichten zwischen Steinen.", "Mensajes entre ladrillos.")
    value("Message()", "@(0xf0000)", message)
    function("SendMessage(const int &message)", "asm { 0xb2, \$message : 0x1000005 };", message)
    function("ClearMessage()", "asm { 0x90 };", message)
    function("IRMode(const int power)", "asm { 0x31, power };", message)
    constants("IR_LO=0 IR_HI=1", message)
    val wait =
        ApiHelp(
            "Waits until a condition is true.",
            "Wartet, bis eine Bedingung wahr ist.",
            "Espera hasta que una condición sea cierta.",
        )
    value("wait(condition)", "while (!(condition))", wait)
    val sleep =
        ApiHelp(
            "Waits, in hundredths of a second.",
            "Wartet, in Hundertstelsekunden.",
            "Espera, en centésimas de segundo.",
        )
    function("Sleep(const int &time)", "asm { 0x43, \$time : 0x15 };", sleep, WAIT)
    val sound = ApiHelp("Plays a sound.", "Spielt einen Klang.", "Toca un sonido.")
    function("PlaySound(const int sound)", "asm { 0x51, sound };", sound, SOUND)
    function(
        "PlayNote(const int frequency, const int time)",
        "asm { 0x23, frequency, frequency >> 8, time };",
        sound,
        null,
        TONE_TIME,
    )
    val stop = ApiHelp("Stops the program.", "Hält das Programm an.", "Para el programa.")
    function("StopAllTasks()", "asm { 0x50 };", stop)
    val display =
        ApiHelp("Chooses what the display shows.", "Wählt, was die Anzeige zeigt.", "Elige qué muestra la pantalla.")
    function("Display(const int &view)", "asm { 0x33, \$view : 0x5 };", display)
    val log = ApiHelp("The datalog.", "Das Datenlog.", "El registro de datos.")
    function("SetDatalog(const int size)", "asm { 0x52, size, size >> 8 };", log)
    function("Datalog(const int &value)", "asm { 0x62, \$value : 0x1004203 };", log)
    function(
        "UploadDatalog(const int first, const int count)",
        "asm { 0xa4, first, first >> 8, count, count >> 8 };",
        log,
    )
}
