/** What System.out does on the display. */
public class Hello {
    public static void main(String[] args) throws Exception {
        System.out.println("x=" + 3.5f * 2 + " " + 1234567890123L); // screen x=7.0 1234567890
        System.out.println("done"); // screen 123
        Thread.sleep(300); // screen done
    }
}
// expect x=7.0 1234567890123
// expect done
