package robotran.legofirmware.messages

import robotran.language.quoted

internal object RunSpanish : RunMessages {
    override fun nestedCall() =
        "Otra subrutina llamó a esta subrutina. Un RCX recuerda un solo camino de vuelta. Por " +
            "eso se paran todas las tareas cuando termina la primera subrutina."

    override fun invalidOpcode(byte: Int, address: Int) =
        "No hay ninguna orden con el número $byte (dirección $address). Esta tarea se para aquí."

    override fun newerCommand(command: String) =
        "El firmware 1.0 no tiene la orden ${quoted(command)}. Esta tarea se para aquí."

    override fun requestOnly(command: String) =
        "${quoted(command)} solo funciona por luz infrarroja. Aquí no hace nada."

    override fun divisionByZero() = "Una división por 0 no cambia nada: la variable conserva su valor."

    override fun datalogFull(entries: Int) =
        "El registro de datos está lleno: $entries entradas. Los demás valores se pierden."

    override fun noDatalog() = "Aún no hay registro de datos, así que este valor se pierde. Crea uno primero."

    override fun noTask(number: Int) = "No hay tarea $number, así que no empieza nada."

    override fun noSub(number: Int) = "No hay subrutina $number, así que no pasa nada."

    override fun noVariable(number: Int) = "No hay variable $number. Su valor es 0."

    override fun noSource(source: Int) = "Un RCX no tiene la fuente $source. Su valor es 0."

    override fun notWritable(source: Int) = "La fuente $source solo se puede leer. No cambia nada."

    override fun wrongPower(power: Int) = "La potencia $power no cuenta. Debe ser de 0 a 7."

    override fun noPort(number: Int) =
        "No hay puerto, temporizador, contador ni evento con el número $number. No pasa nada."

    override fun tooManyLoops() =
        "Como máximo caben cuatro bucles contados uno dentro de otro. Se pierde la cuenta del cuarto."

    override fun noLoop() = "Aquí no hay ningún bucle contado que pueda terminar."

    override fun jumpOut() = "Este salto sale de la tarea o subrutina, que termina."

    override fun task(number: Int) = "tarea $number"

    override fun sub(number: Int) = "subrutina $number"

    override fun localVariables() = "variables propias"

    override fun motorsStayOn() =
        "El programa ha terminado, pero los motores siguen encendidos: el firmware de LEGO no los " +
            "para. Apágalos al final del programa."

    override fun emptySlot(slot: Int) = "No hay programa en el lugar $slot. Elige otro con el botón Prgm."
}
