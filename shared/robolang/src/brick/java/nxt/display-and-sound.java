//// PLAY

/** Plays a tone to its end. */
static void play(int frequency, float seconds) throws InterruptedException {
    int milliseconds = roundHalfUp(seconds * 100) * 10;
    if (milliseconds == 0) return;
    Sound.playTone(frequency, milliseconds);
    Thread.sleep(milliseconds);
}

//// SHOW_TEXT

/** Shows a text in the first row. */
static void show(String text) {
    LCD.clear(0);
    LCD.drawString(text, 0, 0);
}

//// SHOW_WHOLE

/** Shows a whole number with its sign. */
static void show(int number) {
    show(String.valueOf(number));
}

//// SHOW_DECIMAL

/** Shows a number with at most three digits behind its point. */
static void show(float number) {
    float magnitude = number < 0 ? -number : number;
    int decimals = 3;
    int digits = roundHalfUp(magnitude * 10 * 10 * 10);
    while (digits > 9999999 && decimals > 0) {
        decimals--;
        float scaled = magnitude;
        for (int place = 0; place < decimals; place++) scaled *= 10;
        digits = roundHalfUp(scaled);
    }
    int whole = digits;
    int unit = 1;
    for (int place = 0; place < decimals; place++) unit *= 10;
    while (decimals > 1 && whole % 10 == 0) {
        decimals--;
        whole /= 10;
        unit /= 10;
    }
    String text = String.valueOf(whole / unit);
    if (decimals > 0) text += "." + String.valueOf(unit + whole % unit).substring(1);
    show(number < 0 ? "-" + text : text);
}

//// SHOW_COLOUR

/** Shows the name of a colour. */
static void showColour(int colour) {
    String[] names = {"RED", "GREEN", "BLUE", "YELLOW", "NONE", "NONE", "WHITE", "BLACK"};
    show(colour >= 0 && colour < names.length ? names[colour] : "NONE");
}
