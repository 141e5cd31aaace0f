package robotran.javacompiler.messages

internal object SpanishNxjMessages : NxjMessages {
    override fun insteadInNxj(remedy: NxjRemedy): String = when (remedy) {
        NxjRemedy.PRINT -> {
            "System.out.println(\"hola\") escribe una línea en la pantalla."
        }

        NxjRemedy.WAIT -> {
            "Thread.sleep(1000) espera un segundo, igual que Delay.msDelay(1000) de lejos.util."
        }

        NxjRemedy.BUTTONS -> {
            "Un NXT no tiene teclado. Espera un botón: Button.waitForAnyPress()."
        }

        NxjRemedy.SORT_ARRAY -> {
            "Arrays.sort(numeros) ordena un array. Para lo demás, recorre la lista con un \"for\"."
        }

        NxjRemedy.HASH_MAP -> {
            "Usa un HashMap, y guarda sus claves en un ArrayList: un NXT no las dice."
        }

        NxjRemedy.HASH_SET -> {
            "Usa un HashSet o un ArrayList: en el NXT ningún bucle recorre un HashSet."
        }

        NxjRemedy.LINKED_LIST -> {
            "Usa una LinkedList con addLast(), removeFirst() y removeLast()."
        }

        NxjRemedy.FILL_LIST -> {
            "Crea una vacía, como new ArrayList<String>(), y añade cada elemento con add()."
        }

        NxjRemedy.LOOP -> {
            "Recorre los elementos con un bucle: for (String palabra : palabras)."
        }

        NxjRemedy.OWN_CLASS -> {
            "Escribe para eso una interfaz o una clase tuya."
        }

        NxjRemedy.NULL -> {
            "Usa null para lo que puede faltar."
        }

        NxjRemedy.JOIN_TEXTS -> {
            "Une textos con \"+\". LCD.drawInt(numero, 4, 0, 0) escribe en cuatro lugares."
        }

        NxjRemedy.TOKENIZER -> {
            "Un StringTokenizer de java.util separa un texto: new StringTokenizer(texto, \" \")."
        }

        NxjRemedy.COMPARE_TEXTS -> {
            "Un texto tiene en el NXT equals(), startsWith(), indexOf(), substring() y trim()."
        }

        NxjRemedy.INDEX_OF -> {
            "Escribe texto.indexOf(\"parte\") >= 0."
        }

        NxjRemedy.SUBSTRINGS -> {
            "Haz un texto nuevo de partes: texto.substring(0, 2) + \"nuevo\" + texto.substring(2)."
        }

        NxjRemedy.COMPARE_CHARACTERS -> {
            "Compáralo: letra >= 'a' && letra <= 'z'."
        }

        NxjRemedy.CALCULATE -> {
            "Calcúlalo con lo que tiene Math en el NXT, como Math.sqrt, Math.floor y Math.pow."
        }

        NxjRemedy.ARRAY_LOOP -> {
            "Recorre el array con un \"for\". System.arraycopy copia elementos."
        }

        NxjRemedy.THREADS -> {
            "Escribe \"extends Thread\" o \"implements Runnable\", y comparte con \"synchronized\"."
        }

        NxjRemedy.END_THREAD -> {
            "Haz que run() mire una variable que el otro hilo cambia, y que termine."
        }

        NxjRemedy.STOPWATCH -> {
            "System.currentTimeMillis() es el tiempo. Un Stopwatch de lejos.util mide."
        }

        NxjRemedy.LONG_OR_DOUBLE -> {
            "Usa \"long\" para números enteros grandes y \"double\" para los demás."
        }

        NxjRemedy.RANDOM -> {
            "Usa new Random() de java.util."
        }

        NxjRemedy.INSTANCEOF -> {
            "Un NXT olvida los nombres de las clases. Qué es algo lo dice \"instanceof\"."
        }

        NxjRemedy.LCD -> {
            "Un NXT no tiene ventanas. Muestra textos con LCD.drawString(\"hola\", 0, 0)."
        }

        NxjRemedy.PIXELS -> {
            "LCD.setPixel(x, y, 1) dibuja un punto."
        }

        NxjRemedy.FILE_STREAMS -> {
            "Usa un FileInputStream o un FileOutputStream de java.io."
        }

        NxjRemedy.DATA_STREAMS -> {
            "Un DataOutputStream escribe números y textos, y un DataInputStream los lee."
        }

        NxjRemedy.BLUETOOTH -> {
            "Los robots hablan por Bluetooth, mira la clase Bluetooth de lejos.nxt.comm."
        }

        NxjRemedy.BLUETOOTH_BY_NAME -> {
            "Conecta robots por su nombre: Bluetooth.connect(\"red\", NXTConnection.RAW)."
        }

        NxjRemedy.LINE_FEED -> {
            "Escribe \"\\n\"."
        }

        NxjRemedy.NXT_MOTOR -> {
            "La potencia se fija con new NXTMotor(MotorPort.A). Motor.A tiene setSpeed()."
        }

        NxjRemedy.ALWAYS_REGULATED -> {
            "Quítalo: el motor ya mantiene su velocidad. setAcceleration() lo hace suave."
        }

        NxjRemedy.MOTOR_DIRECTIONS -> {
            "Un motor tiene forward(), backward() y stop(), por ejemplo Motor.A.forward();"
        }

        NxjRemedy.MOTOR_ROTATE -> {
            "rotate(90) gira un motor 90 grados."
        }

        NxjRemedy.ROTATION_SPEED -> {
            "Ahora se llama getRotationSpeed()."
        }

        NxjRemedy.IS_MOVING -> {
            "Ahora se llama isMoving()."
        }

        NxjRemedy.DIFFERENTIAL_PILOT -> {
            "Usa new DifferentialPilot(diametroRueda, anchoVia, Motor.A, Motor.C)."
        }

        NxjRemedy.PILOT_SPEEDS -> {
            "Un piloto tiene setTravelSpeed() y setRotateSpeed()."
        }

        NxjRemedy.NAVIGATOR -> {
            "Usa un Navigator de lejos.robotics.navigation."
        }

        NxjRemedy.ODOMETRY -> {
            "Aquí no hay mapas. Un OdometryPoseProvider sabe dónde está el robot."
        }

        NxjRemedy.SENSORS -> {
            "Hay los sensores de LEGO en lejos.nxt y los de lejos.nxt.addon que puedes montar."
        }

        NxjRemedy.COMPASS -> {
            "Hay CompassHTSensor y CompassMindSensor en lejos.nxt.addon."
        }

        NxjRemedy.GYRO -> {
            "Hay GyroSensor en lejos.nxt.addon."
        }

        NxjRemedy.ACCELERATION -> {
            "Hay AccelHTSensor y AccelMindSensor en lejos.nxt.addon."
        }

        NxjRemedy.DISTANCE -> {
            "Miden distancias UltrasonicSensor y OpticalDistanceSensor de lejos.nxt.addon."
        }

        NxjRemedy.COUNT_TURNS -> {
            "Motor.A.getTachoCount() cuenta grados; un RCXRotationSensor en un eje cuenta pasos."
        }

        NxjRemedy.THERMOMETER -> {
            "Usa RCXThermometer de lejos.nxt.addon o TemperatureSensor de lejos.nxt."
        }

        NxjRemedy.RCX_LINK -> {
            "Con un RCX habla un RCXLink de lejos.nxt.addon: link.sendF7(3), link.A.forward()."
        }

        NxjRemedy.ONE_PORT_EACH -> {
            "Cada sensor necesita su propio puerto, de S1 a S4."
        }

        NxjRemedy.MENU_SETTINGS -> {
            "Quítalo: lo que está puesto en el menú ya vale."
        }

        NxjRemedy.NXT_LISTENERS -> {
            "Usa listeners: Button.ENTER.addButtonListener(..), SensorPort.S1.addSensorPortListener(..)."
        }

        NxjRemedy.BREAKPOINTS -> {
            "Un programa no puede mirar dentro del ladrillo. Los puntos de parada muestran hilos y variables."
        }

        NxjRemedy.THREE_MOTORS -> {
            "Solo hay los motores de los puertos del ladrillo: Motor.A, Motor.B y Motor.C."
        }

        NxjRemedy.NOT_EV3 -> {
            "Eso es para un EV3. Este robot tiene un NXT: import lejos.nxt.*;"
        }

        NxjRemedy.MOTOR_OF_PORT -> {
            "Eso es para un EV3. El motor en el puerto A de un NXT es Motor.A."
        }

        NxjRemedy.NOT_RCX -> {
            "Eso es para un RCX. Este robot tiene un NXT: import lejos.nxt.*;"
        }

        NxjRemedy.DRAW -> {
            "LCD.drawInt(7, 0, 0) muestra un número y LCD.drawString(\"hola\", 0, 1) un texto."
        }

        NxjRemedy.SENSOR_PORT -> {
            "Un NXT tiene una clase para cada sensor: new TouchSensor(SensorPort.S1)."
        }

        NxjRemedy.NXT_BUTTONS -> {
            "Un NXT tiene Button.ENTER, Button.LEFT, Button.RIGHT y Button.ESCAPE."
        }
    }

    override fun textsCompared(operator: String): String =
        "\"$operator\" pregunta si son el mismo objeto. Un NXT crea uno nuevo cada vez que usa un texto."

    override fun compareLetters(comparison: String): String = "Compara las letras: $comparison."
}
