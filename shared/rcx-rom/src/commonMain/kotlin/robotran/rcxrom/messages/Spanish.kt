package robotran.rcxrom.messages

import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.messages.PlaceMessages
import robotran.brick.messages.SpanishPlaceMessages
import robotran.brick.messages.place
import robotran.brick.program.ProgramFailure
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.call.RomGap
import robotran.rcxrom.display.LcdIcon
import robotran.rcxrom.display.SegmentIcons
import robotran.rcxrom.infrared.InfraredRange

/**
 * The messages in Spanish. One term per concept: brick - ladrillo, display - pantalla, thread - hilo, power - potencia.
 */
object SpanishBrickMessages : BrickMessages, PlaceMessages by SpanishPlaceMessages {
    override fun failureShown(failure: ProgramFailure) =
        "El programa no puede seguir. ${placed(failure)} Pulsa On-Off para volver al principio."

    override fun threadFailureShown(failure: ProgramFailure) =
        "Un hilo del programa no puede seguir. ${placed(failure)} Pulsa On-Off para que sigan los demás."

    override fun motorsBrakedAtEnd() =
        "El programa ha llegado a su final, así que el ladrillo ha parado los motores, como hace uno de verdad. " +
            "Para que el robot siga andando, el programa también tiene que seguir: con una espera o con un bucle que " +
            "no termina nunca."

    override fun unknownRoutine() = "no pasa nada, aquí no hay ninguna rutina conocida"

    override fun tooFewArguments(routine: String, needed: Int, given: Int) =
        "no pasa nada, $routine necesita $needed argumentos, no $given"

    override fun wrongCodeGroup(routine: String, group: Int) =
        "no pasa nada, $routine quiere un código que empiece por 0x${group.toString(radix = 16)}"

    override fun unknownCode(code: Int) = "no pasa nada, aquí no hay ningún código ${hexadecimal(code)}"

    override fun notModelled(routine: String, gap: RomGap) = "no pasa nada, $routine no está imitado: ${reason(gap)}"

    override fun messageNotModelled(received: String, gap: RomGap) = "$received, pero no pasa nada: ${reason(gap)}"

    override fun setUp(routine: String) = routine

    override fun motor(port: MotorPort, mode: MotorMode, power: Int, ignoredMode: Int?, countedPower: Int?) =
        buildString {
            append("motor ${port.name} ${modeName(mode)} $power")
            if (ignoredMode != null) append(", el modo $ignoredMode no cuenta")
            if (countedPower != null) append(", la potencia $countedPower cuenta como $power")
        }

    override fun readSensor(port: Int) = "leer el sensor $port"

    override fun sensorPower(port: Int, active: Boolean) =
        "sensor $port ${if (active) "con corriente" else "sin corriente"}"

    override fun sensorPowers(ports: List<Int>, active: Boolean) =
        if (ports.isEmpty()) "no cambia ningún sensor" else ports.joinToString { sensorPower(it, active) }

    override fun buttons(held: List<BrickButton>) =
        "botones pulsados: ${held.joinToString { it.label }.ifEmpty { "ninguno" }}"

    override fun onOffKey(held: Boolean) = "el botón On-Off está ${if (held) "pulsado" else "suelto"}"

    override fun battery(raw: Int) = "la pila mide $raw"

    override fun clearDisplay() = "borrar la pantalla"

    override fun refreshDisplay() = "renovar la pantalla"

    override fun segment(code: Int, shown: Boolean) =
        "${if (shown) "mostrar" else "ocultar"} en la pantalla ${segmentName(code)}"

    override fun icon(icon: LcdIcon) = when (icon) {
        LcdIcon.STANDING_MAN -> "muñeco parado"
        LcdIcon.WALKING_MAN -> "muñeco andando"
        LcdIcon.SENSOR_1_VIEW -> "flecha del sensor 1"
        LcdIcon.SENSOR_1_ACTIVE -> "sensor 1 con corriente"
        LcdIcon.SENSOR_2_VIEW -> "flecha del sensor 2"
        LcdIcon.SENSOR_2_ACTIVE -> "sensor 2 con corriente"
        LcdIcon.SENSOR_3_VIEW -> "flecha del sensor 3"
        LcdIcon.SENSOR_3_ACTIVE -> "sensor 3 con corriente"
        LcdIcon.MOTOR_A_VIEW -> "flecha del motor A"
        LcdIcon.MOTOR_A_BACKWARD -> "motor A hacia atrás"
        LcdIcon.MOTOR_A_FORWARD -> "motor A hacia delante"
        LcdIcon.MOTOR_B_VIEW -> "flecha del motor B"
        LcdIcon.MOTOR_B_BACKWARD -> "motor B hacia atrás"
        LcdIcon.MOTOR_B_FORWARD -> "motor B hacia delante"
        LcdIcon.MOTOR_C_VIEW -> "flecha del motor C"
        LcdIcon.MOTOR_C_BACKWARD -> "motor C hacia atrás"
        LcdIcon.MOTOR_C_FORWARD -> "motor C hacia delante"
        LcdIcon.DATALOG_TOP_RIGHT -> "cuarto de círculo arriba a la derecha"
        LcdIcon.DATALOG_BOTTOM_RIGHT -> "cuarto de círculo abajo a la derecha"
        LcdIcon.DATALOG_BOTTOM_LEFT -> "cuarto de círculo abajo a la izquierda"
        LcdIcon.DATALOG_TOP_LEFT -> "cuarto de círculo arriba a la izquierda"
        LcdIcon.DOT_1 -> "punto de carga 1"
        LcdIcon.DOT_2 -> "punto de carga 2"
        LcdIcon.DOT_3 -> "punto de carga 3"
        LcdIcon.DOT_4 -> "punto de carga 4"
        LcdIcon.DOT_5 -> "punto de carga 5"
        LcdIcon.LOW_BATTERY -> "pila gastada"
        LcdIcon.INFRARED_SHORT -> "infrarrojo corto"
        LcdIcon.INFRARED_LONG -> "infrarrojo largo"
        LcdIcon.MINUS -> "signo menos"
        LcdIcon.POINT_1 -> "punto decimal 1"
        LcdIcon.POINT_2 -> "punto decimal 2"
        LcdIcon.POINT_3 -> "punto decimal 3"
    }

    override fun displayNumber(text: String, shortened: Int?, unknownPoint: Int?) = buildString {
        append("número $text en la pantalla")
        if (shortened != null) append(", porque $shortened es demasiado largo")
        if (unknownPoint != null) append(", sin punto, porque no hay ningún código ${hexadecimal(unknownPoint)}")
    }

    override fun programDigit(digit: Int) = "cifra del programa $digit"

    override fun programDigitStays(number: Int) = "la cifra del programa se queda, porque $number no es ninguna"

    override fun queued(sound: String) = "poner en cola $sound"

    override fun playedAtOnce(sound: String) = "tocar enseguida $sound"

    override fun dropped(sound: String) = "descartar $sound, porque la cola de sonidos está llena"

    override fun systemSound(number: Int, played: Int): String {
        val remark = if (played == number) "" else ", porque no existe el $number"
        return "sonido del sistema $played (${SYSTEM_SOUNDS[played]}$remark)"
    }

    override fun tone(hertz: Int, milliseconds: Int) = "tono de $hertz Hz durante $milliseconds ms"

    override fun pause(milliseconds: Int) = "silencio de $milliseconds ms"

    override fun soundPlaying(playing: Boolean) = if (playing) "suena un sonido" else "no suena ningún sonido"

    override fun powerOff() = "dormir hasta que se pulse On-Off"

    override fun startTimer() = "poner en marcha el reloj, con los motores apagados y los sensores sin corriente"

    override fun stopTimer() = "parar el reloj, y con él los motores, los sonidos y los sensores"

    override fun resetMinuteTimer() = "poner a cero el reloj de minutos"

    override fun startInfrared() = "poner en marcha el infrarrojo, a corta distancia"

    override fun stopInfrared() = "apagar el infrarrojo"

    override fun infraredRange(range: InfraredRange) =
        "alcance del infrarrojo: ${if (range == InfraredRange.LONG) "largo" else "corto"}"

    override fun transferPointer(address: Int) = if (address == 0) {
        "los datos recibidos no se guardarán"
    } else {
        "los datos recibidos irán a ${hexadecimal(address)}"
    }

    override fun dataWaiting(waiting: Boolean) =
        if (waiting) "hay un mensaje esperando" else "no hay ningún mensaje esperando"

    override fun received(bytes: Int) = "recibir ${bytes(bytes)}"

    override fun sent(bytes: Int) = "enviar ${bytes(bytes)}"

    override fun stillSending() = "no se envía nada, el mensaje anterior todavía está en camino"

    override fun infraredOff() = "no se envía nada, el infrarrojo está apagado"

    override fun wrongMessageLength(bytes: Int, longest: Int) =
        "no se envía nada, un mensaje tiene de 1 a $longest bytes, no $bytes"

    private fun placed(failure: ProgramFailure) = listOfNotNull(failure.place(this), failure.message).joinToString(": ")

    private fun reason(gap: RomGap) = when (gap) {
        RomGap.TIMER_TICK -> "el ladrillo lo hace él solo cada milisegundo"
        RomGap.DOWNLOAD -> "a este ladrillo los programas llegan sin infrarrojo"
    }

    private fun modeName(mode: MotorMode) = when (mode) {
        MotorMode.FORWARD -> "hacia delante"
        MotorMode.BACKWARD -> "hacia atrás"
        MotorMode.BRAKE -> "frena"
        MotorMode.FLOAT -> "suelto"
    }

    private fun segmentName(code: Int): String = when (code) {
        RomCode.SEGMENT_DATALOG -> "el círculo de datos"
        RomCode.SEGMENT_DOWNLOAD -> "los puntos de descarga"
        RomCode.SEGMENT_UPLOAD -> "los puntos de envío"
        RomCode.SEGMENT_ALL -> "todo"
        else -> SegmentIcons.of(code)?.let(::icon) ?: hexadecimal(code)
    }

    private fun bytes(count: Int) = if (count == 1) "1 byte" else "$count bytes"

    private val SYSTEM_SOUNDS =
        listOf(
            "pitido",
            "dos pitidos",
            "melodía hacia abajo",
            "melodía hacia arriba",
            "zumbido",
            "melodía rápida hacia arriba",
        )
}
