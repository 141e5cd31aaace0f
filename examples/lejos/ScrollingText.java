// Lets a text run across the display, which has room for five
// characters.
// Next: let it run backwards.

import josx.platform.rcx.TextLCD;

public class ScrollingText {
    static final char[] TEXT = "     HELLO ROBOT     ".toCharArray();

    public static void main(String[] args) throws InterruptedException {
        char[] window = new char[5];
        for (int first = 0; first + window.length <= TEXT.length; first++) {
            for (int place = 0; place < window.length; place++) {
                window[place] = TEXT[first + place];
            }
            TextLCD.print(window);
            Thread.sleep(250);
        }
    }
}
