public class StaticMembers {
    static int made;
    final int number;
    static final int[] SHARED = {1, 2, 3};

    static {
        SHARED[0] = 10;
    }

    StaticMembers() {
        number = ++made;
    }

    static StaticMembers make() {
        return new StaticMembers();
    }

    static class Lazy {
        static final Lazy ONLY = new Lazy();
        private int uses;

        static Lazy get() {
            ONLY.uses++;
            return ONLY;
        }
    }

    interface Settings {
        int SPEED = 3 * 7;
        int[] VALUES = {4, 5};
    }

    static class User implements Settings {
        int speed() {
            return SPEED + VALUES[1];
        }
    }

    public static void main(String[] arguments) {
        make();
        make();
        System.out.println(make().number + " " + made); // expect 3 3
        System.out.println(SHARED[0] + StaticMembers.SHARED[2]); // expect 13
        Lazy.get();
        System.out.println(Lazy.get().uses); // expect 2
        System.out.println(new User().speed() + " " + User.SPEED); // expect 26 21
        StaticMembers none = null;
        System.out.println(none.made); // expect 3
    }
}
