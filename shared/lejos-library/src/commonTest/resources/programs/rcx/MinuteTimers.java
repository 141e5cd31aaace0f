import josx.platform.rcx.MinuteTimer;

public class MinuteTimers {
    public static void main(String[] arguments) {
        MinuteTimer.reset(); // rom: 0x339a 0
    }
}
