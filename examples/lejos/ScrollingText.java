import josx.platform.rcx.TextLCD;

/** Lets a text run across the display. */
public class ScrollingText {
    static final char[] TEXT = "     HELLO ROBOT     ".toCharArray();

    public static void main(String[] arguments) throws InterruptedException {
        char[] window = new char[5];
        for (int first = 0; first + window.length <= TEXT.length; first++) {
            for (int place = 0; place < window.length; place++) window[place] = TEXT[first + place];
            TextLCD.print(window);
            Thread.sleep(250);
        }
    }
}
