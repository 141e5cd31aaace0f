public class BuiltInExceptions {
    static int fail(int kind) {
        int[] numbers = new int[2];
        String nothing = null;
        Object text = "text";
        try {
            if (kind == 0) return numbers[2];
            if (kind == 1) return numbers[-1];
            if (kind == 2) return nothing.length();
            if (kind == 3) return 1 / numbers[0];
            if (kind == 4) return 1 % numbers[0];
            if (kind == 5) return ((Thread) text).getPriority();
            numbers.notify();
        } catch (ArrayIndexOutOfBoundsException wrongIndex) {
            return 10;
        } catch (NullPointerException noObject) {
            return 20;
        } catch (ArithmeticException division) {
            return 30;
        } catch (ClassCastException wrongClass) {
            return 40;
        } catch (IllegalMonitorStateException notSynchronized) {
            return 50;
        }
        return 0;
    }

    public static void main(String[] arguments) {
        for (int kind = 0; kind < 7; kind++) System.out.println(fail(kind)); // expect 10
        // expect 10
        // expect 20
        // expect 30
        // expect 30
        // expect 40
        // expect 50
    }
}
