package robotran.nxt.messages

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.messages.PlaceMessages
import robotran.brick.messages.SpanishPlaceMessages
import robotran.brick.messages.place
import robotran.brick.program.ProgramFailure
import robotran.language.listed
import robotran.nxt.hardware.I2cStatus
import robotran.nxt.hardware.SensorPower
import robotran.nxt.hardware.SensorType

/**
 * The messages in Spanish. One term per concept: brick - ladrillo, display - pantalla, thread - hilo, power - potencia,
 * to roll - quedar suelto.
 */
object SpanishNxtMessages : NxtMessages, PlaceMessages by SpanishPlaceMessages {
    override fun failureShown(failure: ProgramFailure) =
        "El programa no puede seguir. ${placed(failure)} Pulsa Escape para volver al menú."

    override fun threadFailureShown(failure: ProgramFailure) =
        "Un hilo del programa no puede seguir. ${placed(failure)} Pulsa Escape para terminar el programa."

    private fun placed(failure: ProgramFailure) = listOfNotNull(failure.place(this), failure.message).joinToString(": ")

    override fun motorsRollAtEnd() =
        "El programa ha llegado a su final, así que el ladrillo ha apagado los motores, como hace uno de " +
            "verdad. Para que el robot siga andando, el programa también tiene que seguir: con una espera o con un " +
            "bucle que no termina nunca."

    override fun wrongArguments() = "no pasa nada, no existe ese puerto o ese valor"

    override fun motor(port: MotorPort, mode: MotorMode, power: Int, brakesInPauses: Boolean) = when (mode) {
        MotorMode.FORWARD, MotorMode.BACKWARD -> {
            val way = if (mode == MotorMode.FORWARD) "adelante" else "atrás"
            "motor ${port.name} $way $power" + if (brakesInPauses) "" else ", suelto en las pausas"
        }

        MotorMode.BRAKE -> "motor ${port.name} frena"
        MotorMode.FLOAT -> "motor ${port.name} suelto"
    }

    override fun resetTachoCount(port: MotorPort) = "el motor ${port.name} cuenta desde 0"

    override fun turnOn(port: MotorPort, speed: String, isForward: Boolean) =
        "el motor ${port.name} gira hacia ${if (isForward) "adelante" else "atrás"} a $speed grados por segundo"

    override fun turnTo(port: MotorPort, speed: String, limit: Int, isHeld: Boolean) =
        "el motor ${port.name} gira hasta $limit a $speed grados por segundo" +
            if (isHeld) "" else " y después queda suelto"

    override fun stopMotor(port: MotorPort, isHeld: Boolean) =
        "el motor ${port.name} se detiene" + if (isHeld) " y queda sujeto" else " y después queda suelto"

    override fun motorSpeed(port: MotorPort, speed: String) = "el motor ${port.name} sigue a $speed grados por segundo"

    override fun motorAcceleration(port: MotorPort, acceleration: Int) =
        "el motor ${port.name} acelera $acceleration grados por segundo en cada segundo"

    override fun rollMotor(port: MotorPort) = "soltar el motor ${port.name}"

    override fun regulateNoMore(port: MotorPort) = "soltar el motor ${port.name}, sin regulación"

    override fun stallThreshold(port: MotorPort, degrees: Int, milliseconds: Int) =
        "el motor ${port.name} está atascado si va $degrees grados por detrás durante $milliseconds ms"

    override fun sensorPower(port: Int, power: Int) = "el sensor $port " + when (power) {
        SensorPower.RCX -> "recibe 9 voltios, menos mientras mide"
        SensorPower.NINE_VOLTS -> "recibe 9 voltios"
        else -> "no recibe corriente"
    }

    override fun pinMode(port: Int, pin: Int, mode: Int) = "sensor $port, el cable $pin " + when (mode) {
        PIN_INPUT -> "se lee"
        PIN_OUTPUT -> "lo pone el ladrillo"
        PIN_MEASURES -> "se mide"
        else -> "no se usa"
    }

    override fun pin(port: Int, pin: Int, isHigh: Boolean) =
        "sensor $port, cable $pin ${if (isHigh) "encendido" else "apagado"}"

    override fun sensorType(port: Int, type: Int) = "el puerto $port tiene " + when (type) {
        SensorType.NO_SENSOR -> "nada"
        SensorType.SWITCH -> "un sensor de contacto"
        SensorType.TEMPERATURE -> "un sensor de temperatura de un RCX"
        SensorType.REFLECTION -> "un sensor de luz de un RCX"
        SensorType.ANGLE -> "un sensor de rotación de un RCX"
        SensorType.LIGHT_ACTIVE -> "un sensor de luz con la lámpara encendida"
        SensorType.LIGHT_INACTIVE -> "un sensor de luz con la lámpara apagada"
        SensorType.SOUND_DB, SensorType.SOUND_DBA -> "un sensor de sonido"
        SensorType.LOWSPEED, SensorType.LOWSPEED_9V, SensorType.HISPEED -> "un sensor que envía bytes"
        in SensorType.COLOUR_FULL..SensorType.COLOUR_NONE -> "un sensor de color"
        else -> "un sensor de otra clase"
    }

    override fun i2cReady(port: Int) = "el sensor $port se prepara para enviar bytes"

    override fun i2cOff(port: Int) = "el sensor $port ya no envía bytes"

    override fun i2cMessage(port: Int, bytes: Int, answer: Int) =
        "enviar ${bytes(bytes)} al sensor $port" + if (answer == 0) "" else " y pedir ${bytes(answer)}"

    override fun i2cRefused(port: Int, status: Int) = "no se envía nada al sensor $port, " + when (status) {
        I2cStatus.BUSY -> "todavía está ocupado"
        I2cStatus.INVALID_LENGTH -> "el mensaje es demasiado largo"
        else -> "no está preparado"
    }

    override fun drawText(text: String, column: Int, row: Int, isInverted: Boolean, gaps: List<String>) = buildString {
        append("dibujar $text en la columna $column, fila $row")
        if (isInverted) append(", en blanco sobre negro")
        if (gaps.isNotEmpty()) append(", pero la pantalla no tiene ${listed(gaps, "ni")}")
    }

    override fun clearDisplay() = "borrar la pantalla"

    override fun drawPicture(width: Int, height: Int, x: Int, y: Int) = "dibujar $width por $height puntos en $x, $y"

    override fun refreshDisplay() = "mostrar en la pantalla lo dibujado"

    override fun refreshEvery(period: Int) =
        if (period == 0) "mostrar lo dibujado solo cuando se pide" else "mostrar lo dibujado cada $period ms"

    override fun contrast(contrast: Int) = "contraste de la pantalla $contrast"

    override fun tone(hertz: Int, milliseconds: Int, volume: Int) =
        "tono de $hertz Hz durante $milliseconds ms con volumen $volume"

    override fun samples(count: Int, perSecond: Int) = "tocar $count muestras, $perSecond por segundo"

    override fun shutDown() = "apagar el ladrillo"

    override fun connectTo(name: String) = "conectar con el robot $name"

    override fun noRobot(name: String) = "no se conecta nada, no hay ningún robot $name"

    override fun awaitConnection() = "esperar a que se conecte otro robot"

    override fun sent(bytes: Int, link: Int) = "enviar ${bytes(bytes)} por la conexión $link"

    override fun notSent(link: Int) = "no se envía nada, la conexión $link no está abierta"

    override fun closeLink(link: Int) = "cerrar la conexión $link"

    override fun exit() = "terminar el programa"

    override fun exception(number: Int) = "mostrar la excepción $number"

    override fun writePage(page: Int) = "escribe la página $page de la memoria flash"

    override fun noPage(page: Int) = "no se escribe nada, la memoria flash no tiene página $page"

    override fun console(text: String) = "anotar $text"

    private fun bytes(count: Int) = if (count == 1) "1 byte" else "$count bytes"
}
