//// PLAY

/** Plays a tone to its end; a long one is several, for the brick plays 2.55 seconds at most. */
static void play(int frequency, float seconds) throws InterruptedException {
    int hundredths = roundHalfUp(seconds * 100);
    while (hundredths > 0) {
        int part = Math.min(hundredths, 255);
        Sound.playTone(frequency, part);
        Thread.sleep(part * 10);
        hundredths -= part;
    }
}

//// SHOW_WHOLE

/** Shows a whole number with its sign. */
static void show(int number) {
    int digits = Math.max(-32768, Math.min(number, 32767));
    LCD.setNumber(LCDConstants.LCD_SIGNED, digits, LCDConstants.LCD_DECIMAL_0);
    LCD.refresh();
}

//// SHOW_DECIMAL

/** Shows a number with as many digits behind its point as there is room for. */
static void show(float number) {
    float magnitude = number < 0 ? -number : number;
    int decimals = 3;
    int digits = roundHalfUp(magnitude * 10 * 10 * 10);
    while (digits > 9999 && decimals > 0) {
        decimals--;
        float scaled = magnitude;
        for (int place = 0; place < decimals; place++) scaled *= 10;
        digits = roundHalfUp(scaled);
    }
    while (decimals > 1 && digits % 10 == 0) {
        decimals--;
        digits /= 10;
    }
    digits = Math.min(digits, 32767);
    LCD.setNumber(LCDConstants.LCD_SIGNED, number < 0 ? -digits : digits, LCDConstants.LCD_DECIMAL_0 + decimals);
    LCD.refresh();
}

//// TIMER_START

/** When the timer began, on the brick's clock. */
static int timerStart = (int) System.currentTimeMillis();

//// TIMER

/** The seconds since the start or the last resetTimer. */
static float timer() {
    return ((int) System.currentTimeMillis() - timerStart) / 1000f;
}

//// RESET_TIMER

/** Lets the timer begin again. */
static void resetTimer() {
    timerStart = (int) System.currentTimeMillis();
}
