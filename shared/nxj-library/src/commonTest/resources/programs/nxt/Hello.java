// screen 0: x=7.0 1234567890
// screen 1: 123
// screen 2: done
/** What System.out does on the display. */
public class Hello {
    public static void main(String[] args) throws Exception {
        System.out.println("x=" + 3.5f * 2 + " " + 1234567890123L); // prints: x=7.0 1234567890123
        System.out.println("done"); // prints: done
        Thread.sleep(300);
    }
}
