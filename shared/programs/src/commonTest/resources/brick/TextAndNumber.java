import josx.platform.rcx.TextLCD;

/** leJOS makes no room for a number behind a text. */
public class TextAndNumber {
    public static void main(String[] args) throws InterruptedException {
        int count = 7;
        TextLCD.print("c" + count); // warning: new StringBuffer(20)
        String both = "a" + 'b' + true;
        both += 1.5f * count; // warning: LCD.showNumber
        Thread.sleep(2000);
    }
}
// display: c7
