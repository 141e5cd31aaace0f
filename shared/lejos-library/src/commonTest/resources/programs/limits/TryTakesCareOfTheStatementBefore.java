import josx.platform.rcx.LCD;

public class TryTakesCareOfTheStatementBefore {
    static int next = 0;

    static void fail() {
        throw new RuntimeException();
    }

    static void call() {
        fail();
        try {
            LCD.showNumber(90);
        } catch (RuntimeException fromBefore) {
            LCD.showNumber(1); // shows: 1
        }
    }

    static void store(int[] numbers) {
        numbers[2] = 7;
        try {
            LCD.showNumber(91);
        } catch (ArrayIndexOutOfBoundsException fromBefore) {
            LCD.showNumber(2); // shows: 2
        }
    }

    static void check(int number) {
        if (number < 0) throw new IllegalArgumentException();
        try {
            LCD.showNumber(92);
        } catch (IllegalArgumentException fromBefore) {
            LCD.showNumber(3); // shows: 3
        }
    }

    static void another() {
        fail();
        try {
            LCD.showNumber(93);
        } catch (ArithmeticException other) {
            LCD.showNumber(94);
        }
    }

    static void between() {
        fail();
        next = 1;
        try {
            LCD.showNumber(95);
        } catch (RuntimeException never) {
            LCD.showNumber(96);
        }
    }

    static void nobody(Job job) {
        job.run();
        try {
            LCD.showNumber(97);
        } catch (RuntimeException notFromAnInterface) {
            LCD.showNumber(98);
        }
    }

    interface Job {
        void run();
    }

    public static void main(String[] arguments) throws InterruptedException {
        call();
        store(new int[2]);
        check(-1);
        for (int way = 0; way < 3; way++) {
            try {
                if (way == 0) another();
                if (way == 1) between();
                if (way == 2) {
                    nobody(new Job() {
                        public void run() {
                            fail();
                        }
                    });
                }
            } catch (RuntimeException notCaughtThere) {
                LCD.showNumber(4 + way); // shows: 4 5 6
            }
        }
    }
}
// mode: brick
