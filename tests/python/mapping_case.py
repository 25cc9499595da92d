"""Shares between the tests of the mapping one object of each class over a library that writes down its calls, and
what is asked of it."""

import ctypes
import unittest

import numpy as np
import rollcon as rc
from rollcon._library import lib

X = np.array([[1.5, 2.5, 3.5], [4.5, 5.5, 6.5]])
WRITTEN = "[1.5 2.5 3.5 4.5 5.5 6.5]"
lib.recorder_said.restype = lib.recorder_missing.restype = ctypes.c_char_p


def said(function):
    return lib.recorder_said(function.encode()).decode()


class MappingCase(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.context = rc.Context()
        cls.body, cls.other = rc.Body(cls.context, "fem"), rc.Body(cls.context, rc.BODY_RIGID)
        cls.contact = rc.Contact(cls.context, cls.body, cls.other)
        cls.wheelrail = rc.WheelRail(cls.context, cls.body, cls.other, "left")
        cls.table = rc.Table(cls.context)

    def tearDown(self):
        lib.recorder_answers(rc.OK)

    def told(self, function, record):
        self.assertEqual(said(function), record, function)

    def fails(self, function, *arguments, **named):
        """Checks that a status and its text arrive."""
        lib.recorder_answers(rc.ERR_STATE)
        with self.assertRaises(rc.RollconError) as caught:
            function(*arguments, **named)
        lib.recorder_answers(rc.OK)
        self.assertEqual((caught.exception.status, caught.exception.message), (rc.ERR_STATE, "text of last_error"))

    def refuses(self, words, function, *arguments, **named):
        with self.assertRaises((ValueError, TypeError, OverflowError)) as caught:
            function(*arguments, **named)
        self.assertIn(words, str(caught.exception))
