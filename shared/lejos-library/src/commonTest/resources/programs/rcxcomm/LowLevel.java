import josx.platform.rcx.LCD;
import josx.rcxcomm.LLC;

/** Sends plain bytes, of which each takes four or five milliseconds, and hears nothing: a brick does not take its own light for another's. */
public class LowLevel {
    static int ask(boolean answer) {
        return answer ? 1 : 0;
    }

    public static void main(String[] arguments) {
        byte[] bytes = {1, 2, 3};
        LLC.init();
        LCD.showNumber(ask(LLC.isSending())); // shows: 0
        int began = (int) System.currentTimeMillis();
        LLC.write(bytes, 3);
        LCD.showNumber(ask(LLC.isSending())); // shows: 1
        while (LLC.isSending()) Thread.yield();
        int time = (int) System.currentTimeMillis() - began;
        LCD.showNumber(ask(time >= 14 && time < 20)); // shows: 1
        LCD.showNumber(ask(LLC.isSendError())); // shows: 0
        LCD.showNumber(ask(LLC.sendBytes(bytes, 2))); // shows: 1
        LCD.showNumber(-LLC.read()); // shows: 1
        began = (int) System.currentTimeMillis();
        LCD.showNumber(-LLC.receive()); // shows: 1
        time = (int) System.currentTimeMillis() - began;
        LCD.showNumber(ask(time >= 10)); // shows: 1
        try {
            LLC.write(null, 2);
        } catch (NullPointerException noBytes) {
            LCD.showNumber(2); // shows: 2
        }
    }
}
